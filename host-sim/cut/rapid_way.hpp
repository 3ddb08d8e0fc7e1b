#pragma once

#include <cstddef>
#include <vector>

#include "host-sim/cut/plan.hpp"

namespace sim::cut {

/// Returns where the rapid to a cut ends, and where the beam is after it: of the way that the
/// program has, which is another one for a controller that finds the way beside parts.
[[nodiscard]] const Place& rapid_end(const Cut& cut);
[[nodiscard]] const Place& beam_end(const Cut& cut);

/// Returns all places of the rapid before a cut, from its start to its end.
/// @param cut number of the cut; that of all cuts for the rapid to the end of the job
[[nodiscard]] std::vector<Place> rapid_before(const CutPlan& plan, std::size_t cut);

/// Returns length and time of all rapids, from the start of the job to the first cut and from the
/// last to its end: from rest to rest between the corners of their ways, as the search reckons.
[[nodiscard]] RapidSum rapids_of(const CutPlan& plan);

/// Returns the length of these, mm.
[[nodiscard]] double rapid_length(const CutPlan& plan);

}  // namespace sim::cut
