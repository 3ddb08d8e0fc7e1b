#pragma once

#include <functional>
#include <vector>

#include "host-sim/surface/path/surface_tracer.hpp"

namespace sim::surface {

/// A slice whose stretch is wanted, all of it.
struct WantedStretch {
  Slice slice;
  StretchUse use = StretchUse::kRow;
};

/// Stretches, and how many of them have lines because no arcs fit.
struct TracedStretches {
  std::vector<SurfaceStretch> stretches;
  std::size_t without_arcs = 0;
};

/// Returns the stretches of slices in their order, traced by as many threads as the machine runs at
/// once: the same to the last bit for any number of them.
/// @param progress is called by the calling thread with the part that is done, 0 to 1; may be empty
[[nodiscard]] TracedStretches traced_slices(const SurfaceTracer& tracer,
                                            const std::vector<WantedStretch>& wanted,
                                            const std::function<void(double)>& progress);

}  // namespace sim::surface
