#include "firmware/machine/machine.hpp"

namespace cnc {

/// Reacts to a change of the filtered inputs. Inputs that stop the machine have priority over
/// inputs that start it.
void Machine::attend_inputs() {
  const hal::InputState& before = inputs_.before();
  const hal::InputState& now = inputs_.settled();
  const auto closed = [](std::uint8_t was, std::uint8_t is) { return (is & ~was) != 0; };
  if (now.emergency_stop && !before.emergency_stop) return emergency_stop();
  const bool limit_closed =
      closed(before.limits, now.limits) || closed(before.second_limits, now.second_limits);
  if (limit_closed && settings().get(setting::kHardLimits) != 0.0F) hit_limit();
  if (now.reset && !before.reset) {
    news_.reset_pressed.raise();
    return reset();
  }
  if (now.door && !before.door) return safety_door();
  if (now.hold && !before.hold) return feed_hold();
  if (now.start && !before.start) resume();
}

}  // namespace cnc
