#include "host-sim/surface/path/traced_slices.hpp"

#include <algorithm>
#include <atomic>
#include <future>
#include <thread>

namespace sim::surface {
namespace {

/// A list of slices from which several threads take the next slice to trace.
class SharedSlices {
 public:
  SharedSlices(const SurfaceTracer& tracer,
               const std::vector<WantedStretch>& wanted,
               std::vector<SurfaceStretch>& stretches)
      : tracer_{tracer}, wanted_{wanted}, stretches_{stretches} {}

  /// Traces slices until the list is empty.
  /// @return the number of pieces that became lines because no arcs are within the tolerance
  std::size_t work(const std::function<void(double)>& progress) {
    TraceRoom room;
    for (std::size_t i = next_++; i < wanted_.size(); i = next_++) {
      const WantedStretch& stretch = wanted_[i];
      stretches_[i] = tracer_.trace(stretch.slice, 0.0, stretch.slice.length, stretch.use, room);
      const auto done = static_cast<double>(++done_);
      if (progress) progress(done / static_cast<double>(wanted_.size()));
    }
    return room.without_arcs;
  }

 private:
  const SurfaceTracer& tracer_;
  const std::vector<WantedStretch>& wanted_;
  std::vector<SurfaceStretch>& stretches_;
  std::atomic<std::size_t> next_{0};
  std::atomic<std::size_t> done_{0};
};

}  // namespace

TracedStretches traced_slices(const SurfaceTracer& tracer,
                              const std::vector<WantedStretch>& wanted,
                              const std::function<void(double)>& progress) {
  TracedStretches traced{.stretches = std::vector<SurfaceStretch>(wanted.size())};
  SharedSlices slices{tracer, wanted, traced.stretches};
  const std::size_t threads =
      std::min<std::size_t>(std::max(1U, std::thread::hardware_concurrency()), wanted.size());
  std::vector<std::future<std::size_t>> others;
  for (std::size_t i = 1; i < threads; ++i) {
    others.push_back(std::async(std::launch::async, [&slices] { return slices.work({}); }));
  }
  traced.without_arcs = slices.work(progress);
  for (std::future<std::size_t>& other : others) traced.without_arcs += other.get();
  return traced;
}

}  // namespace sim::surface
