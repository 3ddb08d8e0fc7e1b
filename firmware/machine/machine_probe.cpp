#include "firmware/machine/machine.hpp"

namespace cnc {

using gcode::Action;

/// Runs a probe: moves straight towards the target until the probe input changes, then brakes
/// within the limits. The remaining motion is dropped. Returns whether the action is done.
bool Machine::probe(const Action& action) {
  using enum ProbeCycle::Phase;
  switch (probing_.phase()) {
    case kNone:
      if (!standstill()) return false;
      if (drive_.probe_contact() == action.probe.towards_contact) {
        end_probe(motion_.target(), false);
        return fail_probe(Alarm::kProbeAtTarget);
      }
      drive_.arm_probe(action.probe.towards_contact);
      append({.element = {.start = motion_.target(), .end = action.end}, .feed_mm_s = action.feed});
      motion_.flush();
      probing_.go_to(kMoving);
      return false;
    case kMoving:
      if (drive_.probe_hit()) {
        motion_.halt();
        probing_.go_to(kStopping);
        return false;
      }
      return motion_.drained() && finish_probe(action);
    case kStopping:
      return motion_.at_rest() && finish_probe(action);
  }
  return true;
}

/// Handles a failed probe. A program stops with an alarm; in a tool change only the line fails.
/// Returns whether the action is done.
bool Machine::fail_probe(Alarm alarm) {
  if (!tool_change_.open()) {
    raise_alarm(alarm);
    return false;
  }
  news_.line_failed.raise();
  interpreter_.set_position(motion_.target());
  return true;
}

bool Machine::finish_probe(const Action& action) {
  drive_.disarm_probe();
  if (!drive_.probe_hit()) {
    end_probe(motion_.target(), false);
    return !action.probe.error_if_missed || fail_probe(Alarm::kProbeMissed);
  }
  AxisArray<std::int32_t> steps = drive_.probe_position();
  for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
    steps[axis] = motion_.tool_at_contact(axis, steps[axis]);
  }
  end_probe(motion_.place_of(steps), true);
  motion_.drop_rest();
  if (!state_.in(Mode::kHold)) motion_.go_on();
  interpreter_.set_position(motion_.target());
  return true;
}

void Machine::end_probe(const Position& place, bool success) {
  probing_.end({.place = place, .success = success});
  news_.probe_ended.raise();
}

}  // namespace cnc
