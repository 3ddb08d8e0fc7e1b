#include "firmware/machine/door_sequence.hpp"

#include <gtest/gtest.h>

namespace cnc {
namespace {

TEST(DoorSequence, ReportsItsStageAsGrblDoes) {
  DoorSequence door;
  EXPECT_EQ(door.substate(true), 1) << "open, and all stands still";
  EXPECT_EQ(door.substate(false), 0);
  door.open(false);
  EXPECT_EQ(door.substate(true), 2);
  for (const DoorStage stage : {DoorStage::kPullOut, DoorStage::kPark}) {
    door.go_to(stage);
    EXPECT_EQ(door.substate(false), 2);
    EXPECT_FALSE(door.is_on_way_back());
  }
  for (const DoorStage stage :
       {DoorStage::kUnpark, DoorStage::kSpindle, DoorStage::kCoolant, DoorStage::kPlunge}) {
    door.go_to(stage);
    EXPECT_EQ(door.substate(true), 3);
    EXPECT_TRUE(door.is_on_way_back());
  }
}

TEST(DoorSequence, KeepsThePlacesOfTheParkingAxisWhenTheDoorOpensAgain) {
  DoorSequence door;
  door.open(true);
  EXPECT_TRUE(door.ends_jog());
  EXPECT_FALSE(door.is_away());
  door.leave({.from = StepPosition::whole(10),
              .pulled_out = StepPosition::whole(20),
              .parked = StepPosition::whole(90)});
  door.go_to(DoorStage::kUnpark);
  door.open(false);
  EXPECT_FALSE(door.ends_jog());
  ASSERT_TRUE(door.is_away());
  EXPECT_EQ(door.places().pulled_out.nearest_step(), 20);
  door.come_back();
  EXPECT_FALSE(door.is_away());
}

}  // namespace
}  // namespace cnc
