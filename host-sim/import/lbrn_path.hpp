#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "host-sim/import/curve.hpp"

namespace sim::drawing {

/// A vertex of a path of LightBurn, with the handles of the curves that leave and reach it.
struct LbrnVertex {
  Place place;
  std::optional<Place> leaving{};
  std::optional<Place> reaching{};
};

/// A line or curve between two vertices, by their numbers.
struct LbrnEdge {
  bool is_curve = false;
  std::size_t from = 0;
  std::size_t to = 0;
};

/// Returns the vertices of a VertList, `V1 2c0x3c0y4c1x5c1y6…`; nothing where it is broken.
[[nodiscard]] std::optional<std::vector<LbrnVertex>> lbrn_vertices(std::string_view list);

/// Returns the edges of a PrimList, `L0 1B1 2…`, or of all vertices where it is `LineClosed` or
/// `LineOpen`; nothing where it is broken or names vertices that are not there.
[[nodiscard]] std::optional<std::vector<LbrnEdge>> lbrn_edges(std::string_view list,
                                                              std::size_t vertices);

/// Returns rows of curves, each beginning where the one before it ends.
/// @pre edges name vertices that are there
[[nodiscard]] std::vector<std::vector<Shape>> lbrn_rows(const std::vector<LbrnVertex>& vertices,
                                                        const std::vector<LbrnEdge>& edges);

}  // namespace sim::drawing
