#include "planner/motion/step_timing.hpp"

#include <algorithm>
#include <cmath>

#include "planner/base/truncate.hpp"

namespace cnc::motion {
namespace {

constexpr float kToQ16 = 65536.0F;
constexpr std::int64_t kHalfStep = std::int64_t{1} << 31;

/// The parabola distance(t) = speed · t + ½ acceleration · t², solved for t.
class Parabola {
 public:
  Parabola(float distance, float speed, float ticks)
      : speed_{std::max(0.0F, speed)},
        acceleration_{2.0F * (distance - speed_ * ticks) / (ticks * ticks)},
        ticks_{ticks} {}

  /// Stable for any sign of the acceleration; clamped to the slice.
  [[nodiscard]] float time_to(float distance) const {
    const float discriminant = speed_ * speed_ + 2.0F * acceleration_ * distance;
    const float sum = speed_ + std::sqrt(std::max(0.0F, discriminant));
    return sum > 0.0F ? std::min(ticks_, 2.0F * distance / sum) : ticks_;
  }

 private:
  float speed_;
  float acceleration_;
  float ticks_;
};

std::int32_t to_q16(float ticks) { return static_cast<std::int32_t>(ticks * kToQ16); }

}  // namespace

StepTrain time_steps(const AxisSlice& slice, float shift) {
  const std::int32_t steps = slice.to.nearest_step() - slice.from.nearest_step();
  if (steps == 0) return {};
  const bool forward = steps > 0;
  const std::int64_t travel = slice.to.q32() - slice.from.q32();
  // From the start to the first half step in the direction of travel.
  const std::int64_t centre = StepPosition::whole(slice.from.nearest_step()).q32();
  const std::int64_t edge = forward ? centre + kHalfStep : centre - kHalfStep;
  const std::int64_t lead = forward ? edge - slice.from.q32() : slice.from.q32() - edge;
  const float first_edge = nearest_float(lead) * StepPosition::kStepsPerUnit;

  const Parabola motion{nearest_float(forward ? travel : -travel) * StepPosition::kStepsPerUnit,
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
  // Through first, middle m and last n: mean interval up to k is I + (k − 1)/2 · G.
  const auto middle_index = static_cast<float>(train.count >> 1U);
  const float middle = motion.time_to(first_edge + middle_index);
  const float mean_to_middle = (middle - first) / middle_index;
  const float growth = 2.0F * (mean - mean_to_middle) / (last_index - middle_index);
  train.growth_q16 = to_q16(growth);
  train.interval_q16 = to_q16(mean_to_middle - 0.5F * (middle_index - 1.0F) * growth);
  return train;
}

}  // namespace cnc::motion
