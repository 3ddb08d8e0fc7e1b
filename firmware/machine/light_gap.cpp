#include "firmware/machine/light_gap.hpp"

#include <utility>

namespace cnc {

void LightGap::begin() {
  end();
  opens_ = true;
  gap_ = {.from = motion_.tool_steps()};
  motion_.keep_path(true);
}

/// While the place is not known exactly, the one of the cycle in which the beam was blocked counts.
void LightGap::find() {
  opens_ = false;
  const std::uint32_t tick = drive_.light_ended();
  if (!motion_.is_lit_after(tick)) return end();
  const motion::PathUnits distance = motion_.distance_since(tick);
  gap_.distance_mm = motion::to_mm(distance);
  unknown_mm_ = motion_.go_back(distance);
  found_ = true;
  if (unknown_mm_ > 0.0F) return;
  for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
    gap_.from[axis] = motion_.place()[axis].nearest_step();
  }
}

void LightGap::end() {
  opens_ = false;
  found_ = false;
  unknown_mm_ = 0.0F;
  motion_.keep_path(false);
}

void LightGap::leave() {
  if (found_) uncut_ = gap_;
  end();
}

bool LightGap::leave_unknown() {
  const bool matters = unknown_mm_ > kNegligibleMm;
  gap_.distance_mm = unknown_mm_;
  if (matters) uncut_ = gap_;
  end();
  return matters;
}

std::optional<Uncut> LightGap::take_uncut() { return std::exchange(uncut_, std::nullopt); }

}  // namespace cnc
