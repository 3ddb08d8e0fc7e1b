#pragma once

#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "host-sim/import/drawing.hpp"

namespace sim::sheet {

/// The treatment of a contour in a job.
struct ContourUse {
  bool is_cut = false;  ///< Whether the contour is cut or engraved. It must then be on the stock.
  /// Whether the contour is closed and is the edge of a part. Its cut is offset by half a kerf, to
  /// the side of the waste.
  bool is_edge = false;
  double kerf_mm = 0.0;  ///< Width of the kerf along an edge.
};

/// Checks the positions of parts. Returns faults that name the parts and a point. Faults are parts
/// that reach into the margin or beyond the stock, parts that overlap, and parts that are nearer to
/// each other than the greater of their kerfs. A part in the hole of another part is correct.
/// Curves are compared as chords within kSheetChordMm of them. The plan of the cuts later makes the
/// same checks more exactly.
/// @param placed drawing that place_parts() returned
/// @param uses one use for each contour
[[nodiscard]] std::vector<drawing::Fault> check_places(const drawing::Drawing& placed,
                                                       std::span<const ContourUse> uses);

inline constexpr double kSheetChordMm = 0.002;

/// Two parts that overlap or are too near, and their smallest distance, which is 0 if outlines
/// cross.
struct PartPair {
  std::pair<std::size_t, std::size_t> parts;  ///< Numbers of the parts, the smaller one first.
  bool overlap = false;
  double distance_mm = 0.0;
  drawing::Place place{0.0, 0.0};
};

/// Returns the pairs of parts that overlap or are too near, in the order of the part numbers. At
/// most `max_pairs` pairs are searched for.
[[nodiscard]] std::vector<PartPair> near_parts(const drawing::Drawing& placed,
                                               std::span<const ContourUse> uses,
                                               std::size_t max_pairs);

}  // namespace sim::sheet
