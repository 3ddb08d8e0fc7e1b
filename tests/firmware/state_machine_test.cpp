#include "firmware/machine/state_machine.hpp"

#include <gtest/gtest.h>

#include <initializer_list>

namespace cnc {
namespace {

/// Returns the mode after these events, none of which may be ignored.
Mode after(std::initializer_list<Event> events) {
  StateMachine machine;
  for (const Event event : events) EXPECT_TRUE(machine.take(event)) << static_cast<int>(event);
  return machine.mode();
}

/// Returns whether an event is ignored after these events.
bool ignored(std::initializer_list<Event> events, Event event) {
  StateMachine machine;
  for (const Event each : events) machine.take(each);
  const Mode before = machine.mode();
  return !machine.allows(event) && !machine.take(event) && machine.mode() == before;
}

TEST(StateMachine, HoldsAndResumes) {
  EXPECT_EQ(after({Event::kHold}), Mode::kHold);
  EXPECT_EQ(after({Event::kHold, Event::kResume}), Mode::kFree);
  EXPECT_EQ(after({Event::kHold, Event::kDoor, Event::kResume}), Mode::kFree);
  EXPECT_TRUE(ignored({}, Event::kResume));
}

TEST(StateMachine, StaysHeldAfterADoorWhereTheOperatorIsToConfirm) {
  EXPECT_EQ(after({Event::kDoor, Event::kStay}), Mode::kHold);
  EXPECT_EQ(after({Event::kDoor, Event::kStay, Event::kResume}), Mode::kFree);
  EXPECT_TRUE(ignored({}, Event::kStay));
  EXPECT_TRUE(ignored({Event::kHold}, Event::kStay));
  EXPECT_TRUE(ignored({Event::kDoor}, Event::kHold));
}

TEST(StateMachine, EndsAJogForWhateverHolds) {
  EXPECT_EQ(after({Event::kJog, Event::kJog, Event::kHold}), Mode::kJogEnding);
  EXPECT_EQ(after({Event::kJog, Event::kJogCancel, Event::kOver}), Mode::kFree);
  EXPECT_EQ(after({Event::kJog, Event::kDoor}), Mode::kDoor);
  EXPECT_TRUE(ignored({Event::kHold}, Event::kJog));
  EXPECT_TRUE(ignored({Event::kJog, Event::kJogCancel}, Event::kJog));
}

TEST(StateMachine, HomesFromIdleAndFromAlarmOnly) {
  EXPECT_EQ(after({Event::kAlarm, Event::kHome, Event::kOver}), Mode::kFree);
  for (const Event event :
       {Event::kHold, Event::kJog, Event::kCheck, Event::kSleep, Event::kDoor}) {
    EXPECT_TRUE(ignored({event}, Event::kHome));
    EXPECT_TRUE(ignored({Event::kHome}, event));
  }
}

TEST(StateMachine, LeavesAnAlarmByUnlockNotByReset) {
  EXPECT_EQ(after({Event::kAlarm, Event::kReset}), Mode::kAlarm);
  EXPECT_EQ(after({Event::kAlarm, Event::kReset, Event::kUnlock}), Mode::kFree);
  EXPECT_TRUE(ignored({Event::kHold}, Event::kUnlock));
}

TEST(StateMachine, WakesByResetOnly) {
  for (const Event event :
       {Event::kHold, Event::kResume, Event::kDoor, Event::kJog, Event::kHome, Event::kUnlock}) {
    EXPECT_TRUE(ignored({Event::kSleep}, event));
  }
  EXPECT_EQ(after({Event::kSleep, Event::kReset}), Mode::kFree);
}

TEST(StateMachine, ResetsAndAlarmsFromEverywhere) {
  for (const Event event :
       {Event::kHold, Event::kDoor, Event::kJog, Event::kHome, Event::kCheck, Event::kTool}) {
    EXPECT_EQ(after({event, Event::kReset}), Mode::kFree);
    EXPECT_EQ(after({event, Event::kAlarm}), Mode::kAlarm);
  }
}

}  // namespace
}  // namespace cnc
