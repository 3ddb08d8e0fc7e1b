#include "planner/motion/segment/joined_slices.hpp"

#include <algorithm>

#include "planner/motion/segment/step_timing.hpp"

namespace cnc::motion {
namespace {

constexpr std::int32_t kTickNs{kNsPerTick};
constexpr float kTicksPerNs = 1.0F / static_cast<float>(kNsPerTick);

bool has_steps(const Segment& segment) {
  return std::any_of(segment.trains.begin(), segment.trains.end(), [](const StepTrain& train) {
    return train.count > 0;
  });
}

}  // namespace

void JoinedSlices::time(const AxisArray<StepPosition>& to, Segment& segment) {
  // Rounding of a stretch can make a segment without duration. The steps of such a segment are due
  // at its start.
  const float ticks = static_cast<float>(std::max<std::uint32_t>(1, duration_ns_)) * kTicksPerNs;
  const float shift = static_cast<float>(remainder_ns_) * kTicksPerNs;
  for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
    if (from_[axis] == to[axis]) continue;
    const AxisSlice slice{
        .from = from_[axis], .to = to[axis], .speed_steps_per_tick = speeds_[axis], .ticks = ticks};
    segment.trains[axis] = time_steps(slice, shift);
    if (slice.to.q32() < slice.from.q32()) {
      segment.negative = static_cast<std::uint8_t>(segment.negative | (1U << axis));
    }
  }
  pass_time(segment);
}

void JoinedSlices::pass_time(Segment& segment) {
  const std::int32_t whole = static_cast<std::int32_t>(duration_ns_) + remainder_ns_;
  segment.ticks = static_cast<std::uint32_t>(std::max<std::int32_t>(0, whole / kTickNs));
  if (segment.ticks == 0 && has_steps(segment)) segment.ticks = 1;
  remainder_ns_ = whole - static_cast<std::int32_t>(segment.ticks) * kTickNs;
}

void JoinedSlices::lend_tick(Segment& segment) {
  segment.ticks = 1;
  remainder_ns_ -= kTickNs;
}

}  // namespace cnc::motion
