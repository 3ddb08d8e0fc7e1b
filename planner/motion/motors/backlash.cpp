#include "planner/motion/motors/backlash.hpp"

#include <cmath>

#include "planner/base/scalar_math.hpp"
#include "planner/base/truncate.hpp"

namespace cnc::motion {
namespace {

/// Least distance that counts as a reversal: a sixteenth of a step, in Q32 steps.
constexpr std::int64_t kNoticed = std::int64_t{1} << 28;

// Greatest first, second and third derivatives of the quintic on 0…1.
constexpr float kGreatestFirst = 1.875F;
constexpr float kGreatestSecond = 5.7735027F;
constexpr float kGreatestThird = 60.0F;

float quintic(float x) { return x * x * x * (10.0F + x * (6.0F * x - 15.0F)); }

}  // namespace

void Backlash::configure(const BacklashSetting& setting) {
  if (!active()) towards_plus_ = setting.starts_towards_plus;
  setting_ = setting;
  low_ = towards_plus_ ? -setting_.steps : 0;
  from_ = 0;
  to_ = 0;
}

void Backlash::stand(StepPosition tool, std::int32_t offset) {
  farthest_q32_ = tool.q32();
  const std::int32_t end = towards_plus_ ? low_ + setting_.steps : low_;
  from_ = offset;
  to_ = end;
  // Play that is not taken up yet will be taken up during the next motion.
  duration_ = seconds_for(end - offset);
  elapsed_ = 0.0F;
}

std::int64_t Backlash::follow(StepPosition tool, float seconds) {
  const bool turned = reverses(tool);
  if (!settled()) {
    elapsed_ += seconds;
    if (elapsed_ >= duration_) from_ = to_;
  }
  if (settled() && turned) turn_round(tool);
  if (settled()) return StepPosition::whole(to_).q32();
  constexpr float kQ16 = 65'536.0F;
  const float way = static_cast<float>(to_ - from_) * quintic(elapsed_ / duration_);
  return StepPosition::whole(from_).q32() + truncated(way * kQ16) * 65'536;
}

/// Returns whether the tool has reversed. Also updates the farthest position of the tool.
bool Backlash::reverses(StepPosition tool) {
  if (!active()) return false;
  const std::int64_t back = towards_plus_ ? farthest_q32_ - tool.q32() : tool.q32() - farthest_q32_;
  if (back <= 0) farthest_q32_ = tool.q32();
  return back > kNoticed;
}

void Backlash::turn_round(StepPosition tool) {
  towards_plus_ = !towards_plus_;
  farthest_q32_ = tool.q32();
  from_ = to_;
  to_ = towards_plus_ ? low_ + setting_.steps : low_;
  duration_ = seconds_for(to_ - from_);
  elapsed_ = 0.0F;
}

/// Returns the shortest time, in s, in which the offset can move by `steps` within the limits of
/// rate, acceleration and jerk.
float Backlash::seconds_for(std::int32_t steps) const {
  const auto way = static_cast<float>(std::abs(steps));
  if (steps == 0) return 0.0F;
  const float seconds = std::max(kGreatestFirst * way / setting_.rate,
                                 std::sqrt(kGreatestSecond * way / setting_.acceleration));
  if (setting_.jerk <= 0.0F) return seconds;
  return std::max(seconds, cube_root(kGreatestThird * way / setting_.jerk));
}

}  // namespace cnc::motion
