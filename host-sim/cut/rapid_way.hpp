#pragma once

#include <cstddef>
#include <vector>

#include "host-sim/cut/plan.hpp"

namespace sim::cut {

/// Return the point where the rapid to a cut ends, and the point where the beam is after the cut.
/// Both are points of the path in the program, which differs from `strokes` if the controller
/// computes the compensated path.
[[nodiscard]] const Place& rapid_end(const Cut& cut);
[[nodiscard]] const Place& beam_end(const Cut& cut);

/// Returns all points of the rapid before a cut, including its ends.
/// @param cut number of the cut; the number of cuts means the rapid to the end of the job
[[nodiscard]] std::vector<Place> rapid_before(const CutPlan& plan, std::size_t cut);

/// Returns length and time of all rapids, from the start of the job to its end. Each leg of a rapid
/// begins and ends at rest, as in the search for the order.
[[nodiscard]] RapidSum rapids_of(const CutPlan& plan);

/// Returns the length of all rapids, mm.
[[nodiscard]] double rapid_length(const CutPlan& plan);

}  // namespace sim::cut
