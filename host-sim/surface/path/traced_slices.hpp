#pragma once

#include <functional>
#include <vector>

#include "host-sim/surface/path/surface_tracer.hpp"

namespace sim::surface {

/// A slice that is to be traced over its whole length.
struct WantedStretch {
  Slice slice;
  StretchUse use = StretchUse::kRow;
};

/// Traced stretches, and the number of those that are lines because no arcs fit.
struct TracedStretches {
  std::vector<SurfaceStretch> stretches;
  std::size_t without_arcs = 0;
};

/// Returns the stretches of slices in their order. They are traced by as many threads as the
/// computer runs at once; the result is the same to the last bit for any number of threads.
/// @param progress called by the calling thread with the share that is done, 0 to 1; may be empty
[[nodiscard]] TracedStretches traced_slices(const SurfaceTracer& tracer,
                                            const std::vector<WantedStretch>& wanted,
                                            const std::function<void(double)>& progress);

}  // namespace sim::surface
