#pragma once

#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "host-sim/import/drawing.hpp"

namespace sim::sheet {

/// The use that a job makes of a contour.
struct ContourUse {
  bool is_cut = false;   ///< Cut or engraved: it has to lie on the stock.
  bool is_edge = false;  ///< The edge of a part, cut half a kerf beside its line; closed.
  double kerf_mm = 0.0;  ///< Of an edge.
};

/// Finds what is wrong with the places of parts, as faults that name the parts and a place: parts
/// beyond the stock less its margin, parts that overlap, and parts that are nearer to each other
/// than the greater of their kerfs. A part in the hole of another one is right. Curves are compared
/// as chords within kSheetChordMm of them; the plan of the cuts looks more closely.
/// @param placed as place_parts() returns it
/// @param uses one for each contour
[[nodiscard]] std::vector<drawing::Fault> check_places(const drawing::Drawing& placed,
                                                       std::span<const ContourUse> uses);

inline constexpr double kSheetChordMm = 0.002;

/// Two parts, and their smallest distance; 0 where their outlines cross.
struct PartPair {
  std::pair<std::size_t, std::size_t> parts;  ///< The smaller number first.
  bool overlap = false;
  double distance_mm = 0.0;
  drawing::Place place{0.0, 0.0};
};

/// Returns the pairs of parts that overlap or are too near, by their numbers. Ends early at
/// `max_pairs`.
[[nodiscard]] std::vector<PartPair> near_parts(const drawing::Drawing& placed,
                                               std::span<const ContourUse> uses,
                                               std::size_t max_pairs);

}  // namespace sim::sheet
