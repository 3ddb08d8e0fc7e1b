#include "host-sim/stock/step_stretches.hpp"

#include <algorithm>
#include <cmath>

namespace sim::stock {

void StepStretches::go_to(const Pose& pose, const StretchOrigin& origin, double time_s) {
  if (!start_) {
    start_ = pose;
    origin_ = origin;
    return;
  }
  if (origin != origin_) finish();
  origin_ = origin;
  const Pose& before = steps_.empty() ? *start_ : steps_.back().pose;
  if (before.x_mm == pose.x_mm && before.y_mm == pose.y_mm && before.z_mm == pose.z_mm) return;
  steps_.push_back({pose, time_s});
  if (steps_.size() >= to_check_) settle(false);
}

void StepStretches::finish() { settle(true); }

/// Returns the greatest deviation of the first `count` steps from the straight line between the
/// start and step `count`; nothing if a step exceeds the tolerance.
std::optional<StepStretches::Offset> StepStretches::fit(std::size_t count) const {
  const Pose& to = steps_[count - 1].pose;
  const double dx = to.x_mm - start_->x_mm;
  const double dy = to.y_mm - start_->y_mm;
  const double dz = to.z_mm - start_->z_mm;
  const double square = dx * dx + dy * dy + dz * dz;
  double side = 0.0;
  double up = 0.0;
  for (std::size_t i = 0; i + 1 < count; ++i) {
    const Pose& pose = steps_[i].pose;
    const double x = pose.x_mm - start_->x_mm;
    const double y = pose.y_mm - start_->y_mm;
    const double z = pose.z_mm - start_->z_mm;
    const double share =
        square > 0.0 ? std::clamp((x * dx + y * dy + z * dz) / square, 0.0, 1.0) : 0.0;
    const double off_x = x - share * dx;
    const double off_y = y - share * dy;
    const double off_z = z - share * dz;
    const double off_side = off_x * off_x + off_y * off_y;
    if (off_side + off_z * off_z > tolerance_mm_ * tolerance_mm_) return std::nullopt;
    side = std::max(side, off_side);
    up = std::max(up, std::abs(off_z));
  }
  return Offset{std::sqrt(side), up};
}

void StepStretches::hand_out(std::size_t count) {
  constexpr double kParts = 4.0;
  const Offset offset = fit(count).value_or(Offset{});
  const double part = tolerance_mm_ / kParts;
  const Step last = steps_[count - 1];
  sink_({.stretch = {.from = *start_,
                     .to = last.pose,
                     .side_slack_mm = part * std::ceil(offset.side_mm / part),
                     .up_slack_mm = offset.up_mm},
         .origin = origin_,
         .end_s = last.time_s});
  start_ = last.pose;
  steps_.erase(steps_.begin(), steps_.begin() + static_cast<std::ptrdiff_t>(count));
  to_check_ = 2;
}

/// Passes the longest fitting stretch to the sink. Finds its number of steps by bisection:
/// `fitting` steps fit, and `too_many` steps do not.
void StepStretches::hand_out_longest(std::size_t fitting, std::size_t too_many) {
  while (too_many - fitting > 1) {
    const std::size_t middle = fitting + (too_many - fitting) / 2;
    (fit(middle) ? fitting : too_many) = middle;
  }
  hand_out(fitting);
}

/// Passes waiting steps on as stretches; if `all`, until no step is left. The number of checked
/// steps doubles each time, so that each step is checked only a few times. The first half of the
/// checked steps is known to fit.
void StepStretches::settle(bool all) {
  while (!steps_.empty() && (all || steps_.size() >= to_check_)) {
    const std::size_t count = std::min(to_check_, steps_.size());
    if (!fit(count)) {
      hand_out_longest(to_check_ / 2, count);
    } else if (count == kMaxSteps || count == steps_.size()) {
      if (!all && count < kMaxSteps) {
        to_check_ *= 2;
        return;
      }
      hand_out(count);
    } else {
      to_check_ *= 2;
    }
  }
}

}  // namespace sim::stock
