#include "firmware/machine/state_machine.hpp"

#include <array>
#include <initializer_list>

namespace cnc {
namespace {

using enum Mode;

constexpr std::uint16_t from(std::initializer_list<Mode> modes) {
  unsigned mask = 0;
  for (const Mode mode : modes) mask |= 1U << static_cast<unsigned>(mode);
  return static_cast<std::uint16_t>(mask);
}

constexpr std::uint16_t kWherever = 0xFFFF;

struct Transition {
  std::uint16_t from;
  Event event;
  Mode to;
};

/// Table of transitions. The first row that contains the mode and the event applies.
constexpr std::array<Transition, 19> kTransitions{{
    {from({kFree}), Event::kHold, kHold},
    {from({kHold, kDoor, kTool}), Event::kResume, kFree},
    {from({kFree, kHold, kJog, kJogEnding}), Event::kDoor, kDoor},
    {from({kDoor}), Event::kStay, kHold},

    {from({kFree, kJog}), Event::kJog, kJog},
    {from({kJog}), Event::kJogCancel, kJogEnding},
    {from({kJog}), Event::kHold, kJogEnding},
    {from({kJog, kJogEnding, kHome}), Event::kOver, kFree},

    {from({kFree, kAlarm}), Event::kHome, kHome},
    {from({kFree}), Event::kCheck, kCheck},
    {from({kCheck}), Event::kCheck, kFree},
    {from({kFree}), Event::kTool, kTool},
    {from({kFree, kAlarm}), Event::kSleep, kSleep},

    {from({kSleep}), Event::kAlarm, kSleep},
    {kWherever, Event::kAlarm, kAlarm},
    {from({kAlarm}), Event::kReset, kAlarm},
    {kWherever, Event::kReset, kFree},
    {from({kAlarm}), Event::kUnlock, kFree},
    {from({kFree}), Event::kUnlock, kFree},
}};

const Transition* find(Mode mode, Event event) {
  for (const Transition& transition : kTransitions) {
    const bool leaves = (transition.from >> static_cast<unsigned>(mode) & 1U) != 0;
    if (leaves && transition.event == event) return &transition;
  }
  return nullptr;
}

}  // namespace

bool StateMachine::allows(Event event) const { return find(mode_, event) != nullptr; }

bool StateMachine::take(Event event) {
  const Transition* const transition = find(mode_, event);
  if (transition == nullptr) return false;
  mode_ = transition->to;
  return true;
}

}  // namespace cnc
