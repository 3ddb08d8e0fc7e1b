#include "planner/motion/segment/step_timing.hpp"

#include <algorithm>
#include <cmath>

#include "planner/base/contract.hpp"

namespace cnc::motion {
namespace {

constexpr float kToQ16 = 65536.0F;
constexpr std::int64_t kHalfStep = std::int64_t{1} << 31;

/// Solves the parabola distance(t) = speed · t + ½ acceleration · t² for t.
class Parabola {
 public:
  Parabola(float distance, float speed, float ticks)
      : speed_{std::max(0.0F, speed)},
        twice_acceleration_{4.0F * (distance - speed_ * ticks) / (ticks * ticks)},
        ticks_{ticks} {}

  /// Returns the time at which `distance` is reached, at most the end of the slice. The formula is
  /// stable for any sign of the acceleration.
  [[nodiscard]] float time_to(float distance) const {
    const float discriminant = speed_ * speed_ + twice_acceleration_ * distance;
    const float sum = speed_ + std::sqrt(std::max(0.0F, discriminant));
    return sum > 0.0F ? std::min(ticks_, 2.0F * distance / sum) : ticks_;
  }

 private:
  float speed_;
  float twice_acceleration_;
  float ticks_;
};

std::int32_t to_q16(float ticks) { return static_cast<std::int32_t>(ticks * kToQ16); }

/// Converts Q32 steps to steps. @pre distance ≥ 0
float to_steps(std::int64_t distance) {
  const auto whole = static_cast<std::uint32_t>(distance >> 32);
  const auto rest = static_cast<std::uint32_t>(distance);
  return static_cast<float>(whole) + static_cast<float>(rest) * StepPosition::kStepsPerUnit;
}

}  // namespace

StepTrain time_steps(const AxisSlice& slice, float shift) {
  const std::int32_t start_step = slice.from.nearest_step();
  const std::int32_t steps = slice.to.nearest_step() - start_step;
  if (steps == 0) return {};
  const bool forward = steps > 0;
  // The plan has at most one step per tick, plus one by rounding. A greater number means that
  // memory was corrupted.
  CNC_ASSERT(static_cast<float>(forward ? steps : -steps) <= slice.ticks + 1.0F);
  const std::int64_t from = slice.from.q32();
  const std::int64_t travel = slice.to.q32() - from;
  const std::int64_t from_centre = from - StepPosition::whole(start_step).q32();
  // Distance, in steps, from the start of the slice to the first position halfway between two
  // steps.
  const float first_edge = to_steps(kHalfStep - (forward ? from_centre : -from_centre));
  const Parabola motion{to_steps(forward ? travel : -travel),
                        forward ? slice.speed_steps_per_tick : -slice.speed_steps_per_tick,
                        slice.ticks};
  StepTrain train;
  train.count = static_cast<std::uint16_t>(forward ? steps : -steps);
  const float first = motion.time_to(first_edge);
  train.first_q16 = to_q16(std::max(0.0F, first + shift));
  if (train.count == 1) return train;

  const auto last_index = static_cast<float>(train.count - 1);
  const float last = motion.time_to(first_edge + last_index);
  const float mean = (last - first) / last_index;
  if (train.count == 2) {
    train.interval_q16 = to_q16(mean);
    return train;
  }
  // The parabola goes through the first step, the middle step m and the last step n. With the first
  // interval I and its growth G, the mean interval up to step k is I + (k − 1)/2 · G.
  const auto middle_index = static_cast<float>(train.count >> 1U);
  const float middle = motion.time_to(first_edge + middle_index);
  const float mean_to_middle = (middle - first) / middle_index;
  const float growth = 2.0F * (mean - mean_to_middle) / (last_index - middle_index);
  train.growth_q16 = to_q16(growth);
  train.interval_q16 = to_q16(mean_to_middle - 0.5F * (middle_index - 1.0F) * growth);
  return train;
}

}  // namespace cnc::motion
