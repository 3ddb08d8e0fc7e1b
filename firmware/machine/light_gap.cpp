#include "firmware/machine/light_gap.hpp"

#include <cmath>
#include <utility>

namespace cnc {

void LightGap::begin() {
  close();
  opens_ = true;
  gap_.from = followed_ = motion_.tool_steps();
  gap_.distance = 0;
  motion_.keep_path(true);
}

/// Adds the chord from the last point to the present position to the length of the gap, if the
/// chord is at least `min_mm` long. On an arc, the sum of the chords is too short by less than 1 %.
void LightGap::follow(float min_mm) {
  const AxisArray<std::int32_t> here = motion_.tool_steps();
  const Position to = motion_.place_of(here);
  const Position from = motion_.place_of(followed_);
  float square = 0.0F;
  for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
    const float way = (to[axis] - from[axis]).mm();
    square += way * way;
  }
  if (square < min_mm * min_mm) return;
  gap_.distance += motion::to_units(std::sqrt(square));
  followed_ = here;
}

/// If the point where the light ended cannot be reached exactly, gap_.from remains the position at
/// begin().
void LightGap::find() {
  opens_ = false;
  const std::uint32_t tick = drive_.light_ended();
  if (!motion_.is_lit_after(tick)) return close();
  gap_.distance = motion_.distance_since(tick);
  unknown_ = motion_.go_back(gap_.distance);
  found_ = true;
  if (unknown_ > 0) return;
  for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
    gap_.from[axis] = motion_.place()[axis].nearest_step();
  }
}

void LightGap::close() {
  opens_ = false;
  found_ = false;
  unknown_ = 0;
  motion_.keep_path(false);
}

void LightGap::leave() {
  if (opens_ && motion_.is_lit_after(drive_.light_ended())) {
    follow(0.0F);
    found_ = gap_.distance > 0;
  }
  reported_ = reported_ || found_;
  close();
}

bool LightGap::end() {
  const bool matters = unknown_ > kNegligible;
  gap_.distance = unknown_;
  reported_ = reported_ || matters;
  close();
  return matters;
}

const Uncut* LightGap::take_uncut() { return std::exchange(reported_, false) ? &gap_ : nullptr; }

}  // namespace cnc
