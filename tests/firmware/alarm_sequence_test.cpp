#include "firmware/machine/alarm_sequence.hpp"

#include <gtest/gtest.h>

namespace cnc {
namespace {

TEST(AlarmSequence, RequiresAResetAfterAlarmsWhoseCauseMustBeSeen) {
  for (const Alarm alarm :
       {Alarm::kHardLimit, Alarm::kSoftLimit, Alarm::kCompensation, Alarm::kStoreDamaged}) {
    AlarmSequence alarms;
    alarms.require_reset_for(alarm);
    EXPECT_TRUE(alarms.needs_reset()) << static_cast<int>(alarm);
    alarms.require_reset_for(Alarm::kProbeMissed);
    EXPECT_TRUE(alarms.needs_reset()) << "a later alarm takes nothing back";
    alarms.set_needs_reset(false);
    EXPECT_FALSE(alarms.needs_reset());
  }
  for (const Alarm alarm :
       {Alarm::kAbortInMotion, Alarm::kProbeMissed, Alarm::kStarved, Alarm::kLinkSilent}) {
    AlarmSequence alarms;
    alarms.require_reset_for(alarm);
    EXPECT_FALSE(alarms.needs_reset()) << static_cast<int>(alarm);
  }
}

TEST(AlarmSequence, StopsOnThePathBeforeTheAlarm) {
  AlarmSequence alarms;
  alarms.stop_for(Alarm::kSoftLimit);
  EXPECT_TRUE(alarms.stops());
  EXPECT_EQ(alarms.stopping_for(), Alarm::kSoftLimit);
  EXPECT_EQ(alarms.now(), Alarm::kNone) << "the motors still brake";
}

TEST(AlarmSequence, KeepsTheAlarmWhenTheRestOfTheMotionIsDropped) {
  AlarmSequence alarms;
  alarms.stop_for(Alarm::kSoftLimit);
  alarms.set(Alarm::kEmergencyStop);
  alarms.set_needs_reset(true);
  alarms.cut_off();
  EXPECT_TRUE(alarms.cuts_off());
  alarms.drop();
  EXPECT_FALSE(alarms.cuts_off());
  EXPECT_FALSE(alarms.stops());
  EXPECT_EQ(alarms.now(), Alarm::kEmergencyStop);
  EXPECT_TRUE(alarms.needs_reset());
  alarms.end();
  EXPECT_EQ(alarms.now(), Alarm::kNone);
}

}  // namespace
}  // namespace cnc
