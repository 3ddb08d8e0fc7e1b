#pragma once

#include <functional>
#include <vector>

#include "host-sim/surface/path/surface_tracer.hpp"

namespace sim::surface {

/// A slice that is to be traced over its complete length.
struct WantedStretch {
  Slice slice;
  StretchUse use = StretchUse::kRow;
};

/// Traced stretches, and the number of pieces that became lines because no arcs are within the
/// tolerance.
struct TracedStretches {
  std::vector<SurfaceStretch> stretches;
  std::size_t without_arcs = 0;
};

/// Returns the stretches of slices, in the order of the slices. Uses as many threads as the
/// computer can run at the same time. The number of threads does not change the result.
/// @param progress called by the calling thread with the finished share, 0 to 1; may be empty
[[nodiscard]] TracedStretches traced_slices(const SurfaceTracer& tracer,
                                            const std::vector<WantedStretch>& wanted,
                                            const std::function<void(double)>& progress);

}  // namespace sim::surface
