#include "firmware/machine/actions_in_progress.hpp"

#include <gtest/gtest.h>

#include <array>

namespace cnc {
namespace {

using gcode::Action;
using gcode::ActionKind;

class ActionsInProgressTest : public testing::Test {
 protected:
  /// Returns the number of cycles that a dwell lasts, a millisecond each.
  int cycles_of_dwell(float seconds) {
    int cycles = 0;
    for (; !actions_.dwell(seconds) && cycles < 10'000; ++cycles) actions_.pass(1000);
    return cycles;
  }

  static constexpr std::array<Action, 2> kLine{
      {{.kind = ActionKind::kLine, .feed = 10.0F}, {.kind = ActionKind::kDwell, .seconds = 0.5F}}};
  ActionsInProgress actions_;
};

TEST_F(ActionsInProgressTest, AreDoneInOrder) {
  EXPECT_TRUE(actions_.empty());
  actions_.begin(kLine, true);
  EXPECT_EQ(actions_.front().kind, ActionKind::kLine);
  actions_.drop_front();
  EXPECT_EQ(actions_.front().kind, ActionKind::kDwell);
  actions_.drop_front();
  EXPECT_TRUE(actions_.empty());
  EXPECT_TRUE(actions_.pauses_after());
  actions_.end_pause_after();
  EXPECT_FALSE(actions_.pauses_after());
}

TEST_F(ActionsInProgressTest, AreSetAsideWithOutputsAndPause) {
  actions_.begin(kLine, true);
  actions_.add_output({.number = 2}, 1);
  const RestOfLine rest = actions_.set_aside();
  EXPECT_TRUE(actions_.empty());
  EXPECT_FALSE(actions_.pauses_after());
  EXPECT_FALSE(actions_.outputs().any());
  actions_.take_back(rest);
  EXPECT_EQ(actions_.front().kind, ActionKind::kLine);
  EXPECT_TRUE(actions_.pauses_after());
  EXPECT_EQ(actions_.outputs().raise, 1U << 2);
}

TEST_F(ActionsInProgressTest, DropTheLineButNotItsOutputs) {
  actions_.begin(kLine, false);
  actions_.elements().begin(kLine[0], {}, ArcFit::kMinToleranceMm);
  actions_.add_output({.number = 0}, 1);
  EXPECT_FALSE(actions_.dwell(1.0F));
  actions_.drop();
  EXPECT_TRUE(actions_.empty());
  EXPECT_FALSE(actions_.elements().active());
  EXPECT_FALSE(actions_.is_dwelling());
  EXPECT_TRUE(actions_.outputs().any());
  actions_.pause();
  actions_.clear();
  EXPECT_FALSE(actions_.outputs().any());
  EXPECT_FALSE(actions_.is_paused());
}

TEST_F(ActionsInProgressTest, GiveAnOutputItsLastLevel) {
  actions_.add_output({.number = 1}, 1);
  actions_.add_output({.number = 3}, 0);
  actions_.add_output({.number = 1}, 0);
  EXPECT_EQ(actions_.outputs().raise, 0);
  EXPECT_EQ(actions_.outputs().lower, 0b1010);
  actions_.forget_outputs();
  EXPECT_FALSE(actions_.outputs().any());
}

TEST_F(ActionsInProgressTest, ChangeOneAnalogOutputWithAMotion) {
  EXPECT_FALSE(actions_.changes_other_analog(0));
  actions_.add_output({.number = 0, .analog = true}, 40'000);
  EXPECT_FALSE(actions_.changes_other_analog(0));
  EXPECT_TRUE(actions_.changes_other_analog(1));
  actions_.add_output({.number = 1, .analog = true}, 500);
  EXPECT_EQ(actions_.outputs().analog_channel, 1);
  EXPECT_EQ(actions_.outputs().analog_value, 500);
}

TEST_F(ActionsInProgressTest, DwellOnceForEachAction) {
  EXPECT_EQ(cycles_of_dwell(0.5F), 501);
  EXPECT_FALSE(actions_.is_dwelling());
  EXPECT_EQ(cycles_of_dwell(0.1F), 101) << "the next one begins anew";
  EXPECT_EQ(cycles_of_dwell(0.0F), 0);
}

}  // namespace
}  // namespace cnc
