#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "host-sim/import/curve.hpp"

namespace sim::drawing {

/// A vertex of a path of LightBurn, with the handles of the curves that begin and end at it.
struct LbrnVertex {
  Place place;
  std::optional<Place> leaving{};
  std::optional<Place> reaching{};
};

/// A line or curve between two vertices, which are given by their indices.
struct LbrnEdge {
  bool is_curve = false;
  std::size_t from = 0;
  std::size_t to = 0;
};

/// Returns the vertices of a VertList, `V1 2c0x3c0y4c1x5c1y6…`; nothing if the list is broken.
[[nodiscard]] std::optional<std::vector<LbrnVertex>> lbrn_vertices(std::string_view list);

/// Returns the edges of a PrimList, `L0 1B1 2…`. For `LineClosed` and `LineOpen`, returns lines
/// that join all vertices in order. Returns nothing if the list is broken or names vertices that do
/// not exist.
[[nodiscard]] std::optional<std::vector<LbrnEdge>> lbrn_edges(std::string_view list,
                                                              std::size_t vertices);

/// Returns the edges as rows of curves. Each curve of a row begins where the curve before it ends.
/// @pre edges name vertices that exist
[[nodiscard]] std::vector<std::vector<Shape>> lbrn_rows(const std::vector<LbrnVertex>& vertices,
                                                        const std::vector<LbrnEdge>& edges);

}  // namespace sim::drawing
