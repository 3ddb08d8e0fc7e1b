#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "host-sim/cut/stroke.hpp"

namespace sim::cut {

/// A stretch of a path along which another path runs in the opposite direction.
struct SharedStretch {
  double from_mm = 0.0;  ///< Start of the stretch, as a distance along the path.
  double to_mm = 0.0;    ///< End of the stretch, above `from_mm`.
  double off_mm = 0.0;   ///< Greatest distance between the two paths along the stretch.
};

/// Returns the stretch of a stroke along which another stroke runs in the opposite direction,
/// nowhere farther away than `tolerance_mm`. Lines are compared only with lines, and arcs only with
/// arcs. Returns nothing if there is no stretch of at least a micrometre.
[[nodiscard]] std::optional<SharedStretch> shared_stretch(const Stroke& stroke,
                                                          const Stroke& other,
                                                          double tolerance_mm);

/// Sorts stretches of one path, and joins those that are less than a micrometre apart.
void join_stretches(std::vector<SharedStretch>& stretches);

/// Returns the parts of a closed path that are outside of the stretches, each as one row; none if
/// the stretches cover the path.
/// @pre the stretches are sorted, joined, and not empty
[[nodiscard]] std::vector<std::vector<Stroke>> rests_between(
    const MeasuredRow& path, const std::vector<SharedStretch>& stretches);

/// Returns the parts of an open path that are outside of the stretches, in the order of the path.
[[nodiscard]] std::vector<std::vector<Stroke>> rests_of_open(
    const MeasuredRow& path, const std::vector<SharedStretch>& stretches);

}  // namespace sim::cut
