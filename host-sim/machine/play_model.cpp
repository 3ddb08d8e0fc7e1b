#include "host-sim/machine/play_model.hpp"

#include <algorithm>
#include <cmath>

namespace sim {

void PlayModel::place(const cnc::Settings& settings) {
  const auto homes_low = static_cast<unsigned>(settings.get(cnc::setting::kHomingDirectionInvert));
  for (std::size_t axis = 0; axis < axes_.size(); ++axis) {
    const auto set = static_cast<double>(settings.get(cnc::setting::kBacklash, axis));
    const auto scale = static_cast<double>(settings.get(cnc::setting::kStepsPerMm, axis));
    const double play = model_.backlash_mm[axis].value_or(set);
    const auto steps = static_cast<std::int32_t>(std::lround(play * scale));
    if (high_[axis] - low_[axis] == steps) continue;
    const bool pulled_off_to_plus = (homes_low >> axis & 1U) != 0;
    // An axis that was moved in the positive direction is behind its motor by the full play.
    const bool behind = pulled_off_to_plus != model_.backlash_lies_otherwise;
    const std::int32_t beyond = axes_[axis] - motors_[axis];
    low_[axis] = behind ? beyond : beyond - steps;
    high_[axis] = low_[axis] + steps;
  }
  any_ = low_ != high_;
}

const PlayModel::Steps& PlayModel::follow(const Steps& motors) {
  motors_ = motors;
  return axes_ = axes(motors);
}

PlayModel::Steps PlayModel::axes(const Steps& motors) const {
  Steps found{};
  for (std::size_t axis = 0; axis < found.size(); ++axis) {
    found[axis] = std::clamp(axes_[axis], motors[axis] + low_[axis], motors[axis] + high_[axis]);
  }
  return found;
}

}  // namespace sim
