#include "planner/motion/motor_path.hpp"

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
  for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
    chord_[axis] = end_[axis].q32() - start_[axis].q32();
    chord_per_mm_[axis] = static_cast<float>(chord_[axis]) * per_mm;
  }
  for (std::size_t i = 0; i < normal_.size(); ++i) {
    normal_[i] = block.normal[i].q32();
    normal_per_mm_[i] = static_cast<float>(normal_[i]) * per_mm;
  }
}

MotorState MotorPath::at(std::uint64_t fraction) const {
  MotorState state;
  state.speed = chord_per_mm_;
  if (fraction >= kWhole) {
    if (turns_) lay_turn_over(0xFFFF'FFFFU, state);
    state.place = end_;
    return state;
  }
  const auto within = static_cast<std::uint32_t>(fraction);
  for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
    if (chord_[axis] == 0) {
      state.place[axis] = start_[axis];
    } else {
      state.place[axis] = StepPosition{start_[axis].q32() + share(chord_[axis], within)};
    }
  }
  if (turns_) lay_turn_over(within, state);
  return state;
}

void MotorPath::lay_turn_over(std::uint32_t fraction, MotorState& state) const {
  const ChordPoint point = frame_.at(fraction);
  const std::array<std::size_t, 2> plane{axes_.first, axes_.second};
  for (std::size_t i = 0; i < plane.size(); ++i) {
    const std::size_t axis = plane[i];
    state.place[axis] = StepPosition{start_[axis].q32() + scaled(chord_[axis], point.along_q30) +
                                     scaled(normal_[i], point.across_q30)};
    state.speed[axis] =
        chord_per_mm_[axis] * point.along_rate + normal_per_mm_[i] * point.across_rate;
  }
}

}  // namespace cnc::motion
