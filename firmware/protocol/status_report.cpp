#include "firmware/protocol/status_report.hpp"

#include <array>
#include <string_view>

#include "planner/base/units.hpp"

namespace cnc {
namespace {

// Bits of $10.
constexpr std::uint32_t kMachinePosition = 1;
constexpr std::uint32_t kBuffers = 2;
constexpr std::uint32_t kLineNumber = 4;
constexpr std::uint32_t kFeedAndSpeed = 8;
constexpr std::uint32_t kPins = 16;
constexpr std::uint32_t kWorkOffset = 32;
constexpr std::uint32_t kOverrides = 64;
constexpr std::uint32_t kGrblBits = kMachinePosition | kBuffers;
/// Smallest value of $10 that is read as grblHAL's mask. Smaller values are read as Grbl's mask or
/// its older masks. For smaller values all other fields are shown, because a sender for Grbl needs
/// WCO to compute the work position.
constexpr std::uint32_t kFirstOfGrblHal = kWorkOffset;

// Number of reports between two reports with a slow field, as in Grbl.
constexpr int kOffsetPauseAtRest = 10;
constexpr int kOffsetPauseMoving = 30;
constexpr int kOverridePauseAtRest = 10;
constexpr int kOverridePauseMoving = 20;

std::uint32_t fields(const Machine& machine, bool full) {
  const auto chosen = static_cast<std::uint32_t>(machine.settings().get(setting::kStatusReport));
  if (full) return ~kMachinePosition | (chosen & kMachinePosition);
  return chosen < kFirstOfGrblHal ? (chosen & kGrblBits) | ~kGrblBits : chosen;
}

Position work_offset(const Machine& machine) {
  Position offset;
  for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
    offset[axis] = machine.interpreter().work_offset(static_cast<Axis>(axis));
  }
  return offset;
}

void put_state(Reply& reply, const Machine& machine, bool full) {
  const MachineStatus status = machine.status();
  reply.letter('<').text(name_of(status.state));
  if (status.state == MachineState::kHold || status.state == MachineState::kDoor) {
    reply.letter(':').number(status.substate);
  } else if (full && status.state == MachineState::kAlarm) {
    reply.letter(':').number(static_cast<std::uint32_t>(machine.alarm()));
  }
}

void put_position(
    Reply& reply, Position place, const Position& offset, bool work, const ReportForm& form) {
  if (work) {
    for (std::size_t axis = 0; axis < kAxisCount; ++axis) place[axis] -= offset[axis];
  }
  reply.text(work ? "|WPos:" : "|MPos:");
  put_places(reply, place, form);
}

void put_feed_and_speed(Reply& reply, const Machine& machine, const ReportForm& form) {
  const float feed = machine.motion().speed_mm_min();
  reply.text("|FS:").whole(form.inches ? feed / kMillimetresPerInch : feed);
  reply.letter(',').whole(machine.spindle_now());
}

/// Writes the active inputs. Block delete is reported as an input, as in grblHAL. It is on by
/// default, so only the full report shows it.
void put_pins(Reply& reply, const hal::InputState& inputs, bool block_delete) {
  std::array<char, kAxisCount + 7> letters{};
  std::size_t count = 0;
  const auto add = [&](bool active, char letter) {
    if (active) letters[count++] = letter;
  };
  const auto limits = static_cast<unsigned>(inputs.limits | inputs.second_limits);
  for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
    add((limits >> axis & 1U) != 0, kAxisLetters[axis]);
  }
  add(inputs.probe, 'P');
  add(inputs.door, 'D');
  add(inputs.hold, 'H');
  add(inputs.reset, 'R');
  add(inputs.start, 'S');
  add(inputs.emergency_stop, 'E');
  add(block_delete, 'L');
  if (count > 0) reply.text("|Pn:").text({letters.data(), count});
}

void put_accessories(Reply& reply, gcode::SpindleMode spindle, const gcode::Coolant& coolant) {
  const bool turns = spindle != gcode::SpindleMode::kOff;
  if (!turns && !coolant.flood && !coolant.mist) return;
  reply.text("|A:");
  if (turns) reply.letter(spindle == gcode::SpindleMode::kConstant ? 'S' : 'C');
  if (coolant.flood) reply.letter('F');
  if (coolant.mist) reply.letter('M');
}

void put_rest_of_full(Reply& reply, const Machine& machine, const ReportForm& form) {
  const gcode::ModalState& modes = machine.interpreter().state();
  const std::uint32_t axes = (1U << form.axes) - 1U;
  const bool all = (machine.homed() & axes) == axes;
  reply.text("|WCS:").text(name_of_system(modes.coordinate_system));
  reply.text(all ? "|H:1," : "|H:0,").number(machine.homed());
  reply.text("|T:").number(modes.tool);
  reply.text(modes.tool_length_in_use ? "|TLR:1" : "|TLR:0");
}

}  // namespace

void StatusReport::write(Reply& reply,
                         const Machine& machine,
                         std::uint32_t receive_room,
                         const ReportForm& form,
                         bool full) {
  const std::uint32_t shown = fields(machine, full);
  const Position offset = work_offset(machine);
  put_state(reply, machine, full);
  put_position(reply, machine.motion().tool_place(), offset, (shown & kMachinePosition) == 0, form);
  if ((shown & kBuffers) != 0) {
    const auto blocks = static_cast<std::uint32_t>(machine.motion().blocks_free());
    reply.text("|Bf:").number(blocks).letter(',').number(receive_room);
  }
  const std::uint32_t line = machine.motion().line_in_execution();
  if ((shown & kLineNumber) != 0 && line != 0) reply.text("|Ln:").number(line);
  if ((shown & kFeedAndSpeed) != 0) put_feed_and_speed(reply, machine, form);
  if ((shown & kPins) != 0)
    put_pins(reply, machine.inputs(), full && machine.interpreter().options().block_delete);
  put_slow_fields(reply, machine, offset, form, shown, full);
  if (full) put_rest_of_full(reply, machine, form);
  reply.letter('>').end();
}

void StatusReport::put_slow_fields(Reply& reply,
                                   const Machine& machine,
                                   const Position& offset,
                                   const ReportForm& form,
                                   std::uint32_t shown,
                                   bool full) {
  const MachineState state = machine.state();
  const bool moving = state != MachineState::kIdle && state != MachineState::kAlarm;
  if ((shown & kWorkOffset) != 0 && (offset_is_due(offset, moving) || full)) {
    reply.text("|WCO:");
    put_places(reply, offset, form);
  }
  if ((shown & kOverrides) == 0 || !(overrides_are_due(machine, moving) || full)) return;
  reply.text("|Ov:").number(static_cast<std::uint32_t>(told_.percent.feed));
  reply.letter(',').number(static_cast<std::uint32_t>(told_.percent.rapid));
  reply.letter(',').number(static_cast<std::uint32_t>(told_.percent.power));
  put_accessories(reply, told_.spindle, told_.coolant);
}

bool StatusReport::offset_is_due(const Position& offset, bool moving) {
  if (offset == told_offset_ && --offset_wait_ >= 0) return false;
  told_offset_ = offset;
  offset_wait_ = moving ? kOffsetPauseMoving : kOffsetPauseAtRest;
  // If Ov is due as well but has not changed, it follows in the next report.
  if (override_wait_ == 0) override_wait_ = 1;
  return true;
}

bool StatusReport::overrides_are_due(const Machine& machine, bool moving) {
  const Accessories now{machine.overrides(), machine.tool().mode_now(), machine.coolant()};
  const bool same = now.percent.feed == told_.percent.feed &&
                    now.percent.rapid == told_.percent.rapid &&
                    now.percent.power == told_.percent.power && now.spindle == told_.spindle &&
                    now.coolant == told_.coolant;
  if (same && --override_wait_ >= 0) return false;
  told_ = now;
  override_wait_ = moving ? kOverridePauseMoving : kOverridePauseAtRest;
  return true;
}

}  // namespace cnc
