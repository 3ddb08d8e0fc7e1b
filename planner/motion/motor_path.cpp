#include "planner/motion/motor_path.hpp"

#include <algorithm>

#include "planner/base/truncate.hpp"

namespace cnc::motion {
namespace {

constexpr std::uint64_t kWhole = std::uint64_t{1} << 32;

/// length · fraction / 2^32, exact but for the last bit.
std::int64_t share(std::int64_t length, std::uint32_t fraction) {
  const std::int64_t high = (length >> 32) * static_cast<std::int64_t>(fraction);
  const std::uint64_t low = static_cast<std::uint64_t>(static_cast<std::uint32_t>(length)) *
                            static_cast<std::uint64_t>(fraction);
  return high + static_cast<std::int64_t>(low >> 32);
}

/// length · factor / 2^30 for |factor| ≤ 2^30.
std::int64_t scaled(std::int64_t length, std::int32_t factor_q30) {
  const std::int64_t high = (length >> 32) * factor_q30;
  const std::int64_t low =
      static_cast<std::int64_t>(static_cast<std::uint32_t>(length)) * factor_q30;
  return high * 4 + (low >> 30);
}

}  // namespace

MotorPath::MotorPath(const Block& block, const AxisArray<StepPosition>& start)
    : frame_{block.turn.half_sweep},
      start_{start},
      end_{block.end},
      axes_{axes_of(block.turn.plane)},
      turns_{block.turns()} {
  const float per_mm = StepPosition::kStepsPerUnit / block.length;
  for (std::size_t i = 0; i < normal_.size(); ++i) {
    normal_[i] = block.normal[i].q32();
    normal_per_mm_[i] = nearest_float(normal_[i]) * per_mm;
  }
  for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
    chord_[axis] = end_[axis].q32() - start_[axis].q32();
    if (chord_[axis] == 0 && in_plane(axis) == kOffPlane) continue;
    chord_per_mm_[axis] = nearest_float(chord_[axis]) * per_mm;
    moving_[count_++] = static_cast<std::uint8_t>(axis);
  }
}

MotorPath::Point MotorPath::at(std::uint64_t fraction) const {
  Point point{.fraction = fraction};
  if (turns_) point.turn = frame_.at(static_cast<std::uint32_t>(std::min(fraction, kWhole - 1)));
  return point;
}

StepPosition MotorPath::place(std::size_t axis, const Point& point) const {
  if (point.fraction >= kWhole) return end_[axis];
  const std::int64_t from = start_[axis].q32();
  const std::size_t i = in_plane(axis);
  if (i == kOffPlane) {
    return StepPosition{from + share(chord_[axis], static_cast<std::uint32_t>(point.fraction))};
  }
  return StepPosition{from + scaled(chord_[axis], point.turn.along_q30) +
                      scaled(normal_[i], point.turn.across_q30)};
}

float MotorPath::speed(std::size_t axis, const Point& point) const {
  const std::size_t i = in_plane(axis);
  if (i == kOffPlane) return chord_per_mm_[axis];
  return chord_per_mm_[axis] * point.turn.along_rate + normal_per_mm_[i] * point.turn.across_rate;
}

}  // namespace cnc::motion
