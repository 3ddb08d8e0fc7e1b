#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "host-sim/cut/stroke.hpp"

namespace sim::cut {

/// A stretch of a path along which another path runs back.
struct SharedStretch {
  double from_mm = 0.0;  ///< Along the path…
  double to_mm = 0.0;    ///< …and more than that.
  double off_mm = 0.0;   ///< Greatest distance between both paths there.
};

/// Returns the stretch of a stroke beside which another one runs in the opposite direction, nowhere
/// farther than `tolerance_mm`: lines beside lines, and arcs beside arcs. None where they share
/// less than a micrometre.
[[nodiscard]] std::optional<SharedStretch> shared_stretch(const Stroke& stroke,
                                                          const Stroke& other,
                                                          double tolerance_mm);

/// Sorts stretches of one path and joins those that meet within a micrometre.
void join_stretches(std::vector<SharedStretch>& stretches);

/// Returns what stretches leave of a closed path, each rest in one piece; none where they leave
/// nothing.
/// @pre the stretches are sorted, joined, and not empty
[[nodiscard]] std::vector<std::vector<Stroke>> rests_between(
    const MeasuredRow& path, const std::vector<SharedStretch>& stretches);

/// Returns the same of an open path, in its order.
[[nodiscard]] std::vector<std::vector<Stroke>> rests_of_open(
    const MeasuredRow& path, const std::vector<SharedStretch>& stretches);

}  // namespace sim::cut
