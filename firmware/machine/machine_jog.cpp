#include "firmware/machine/machine.hpp"

namespace cnc {
namespace {
constexpr std::uint8_t kNotIdle = 8;
constexpr std::uint8_t kBeyondTravel = 15;
}  // namespace

std::optional<JogRefusal> Machine::jog(std::string_view words) {
  CNC_ASSERT(!busy());
  const bool from_rest = state_.in(Mode::kFree) && idle();
  const bool changes_tool = tool_change_.stage() == ToolChange::Stage::kOpen;
  if (!from_rest && !state_.in(Mode::kJog) && !changes_tool) return JogRefusal{.number = kNotIdle};
  forget_exit();
  const Position here = interpreter_.position();
  const auto actions = interpreter_.interpret_jog(words);
  if (!actions.ok()) {
    const auto number = static_cast<std::uint8_t>(actions.error().code());
    return JogRefusal{.number = number, .fault = actions.error()};
  }
  const gcode::Action& action = actions.value().front();
  Position end = action.end;
  if (leaves_travel(actions.value(), here)) {
    // Under G43.4 a jog cannot be limited axis by axis, because rotary axes move the tip.
    if (settings().get(setting::kJogLimited) == 0.0F || tool_centre_.active()) {
      interpreter_.set_position(here);
      return JogRefusal{.number = kBeyondTravel};
    }
    end = travel_.clamped(end);
    interpreter_.set_position(end);
  }
  if (!changes_tool) static_cast<void>(state_.take(Event::kJog));
  jog_ = JogMove{.end = end, .feed = action.feed, .line = interpreter_.jog_line_number()};
  if (!changes_tool) attend_jog();
  return {};
}

void Machine::append_jog() {
  drive_straight(jog_->end, jog_->feed, jog_->line);
  jog_.reset();
}

/// Appends a straight motion without overrides and with the beam off. A feed of 0 means a rapid.
void Machine::drive_straight(const Position& end, float feed_mm_s, std::uint32_t line) {
  const auto appended =
      motion_.append({.request = {.element = {.start = motion_.target(), .end = end},
                                  .feed_mm_s = feed_mm_s,
                                  .beam = beam_for(true),
                                  .line = line,
                                  .fixed_feed = true}});
  CNC_ASSERT(appended.ok());
  motion_.flush();
}

void Machine::attend_jog() {
  if (state_.in(Mode::kJogEnding)) {
    if (!motion_.at_rest()) return;
    drop_jog();
  } else {
    if (jog_ && motion_.has_room()) return append_jog();
    if (jog_ || !motion_.drained()) return;
  }
  static_cast<void>(state_.take(Event::kOver));
}

/// Drops the remaining motion of a cancelled jog.
/// @pre motion_.at_rest()
void Machine::drop_jog() {
  jog_.reset();
  motion_.drop_rest();
  motion_.go_on();
  interpreter_.set_position(motion_.target());
}

}  // namespace cnc
