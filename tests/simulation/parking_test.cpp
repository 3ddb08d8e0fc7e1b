#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/machine_bench.hpp"
#include "tests/support/random_source.hpp"
#include "tests/support/trials.hpp"

namespace proof {
namespace {

using cnc::MachineState;

class Mill : public MachineBench {
 public:
  Mill() : MachineBench{model()} {
    set({{22, 1}, {24, 60}, {25, 3000}, {26, 20}, {27, 5}, {130, 60}, {131, 40}, {132, 40}});
    set({{41, 1}, {42, 2}, {56, 3}, {57, 600}, {58, -6}, {59, 2000}, {392, 0.3}, {393, 0.2}});
    home();
  }
  void door(bool open) {
    controller.panel().door = open;
    run(5);
  }
  int substate() {
    return machine().state() == MachineState::kDoor ? machine().status().substate : -1;
  }

 private:
  static sim::MachineModel model() {
    sim::MachineModel model;
    model.switch_mm = {12.0, 7.0, 3.0, {}, {}, {}};
    return model;
  }
};

TEST(Parking, PullsOutParksAndComesBackToTheSamePlace) {
  Mill mill;
  mill.send("G0 X-50 Y-20 Z-30");
  mill.send("M3 S500");
  mill.send("M8");
  mill.send("G1 X-10 F1200");
  mill.run(2500);
  mill.door(true);
  mill.run(100);
  EXPECT_EQ(mill.substate(), 2);
  mill.run(2500);
  EXPECT_EQ(mill.substate(), 1);
  EXPECT_NEAR(mill.mm(2), -6.0, 0.003);
  EXPECT_FALSE(mill.controller.port().spindle_enabled);
  EXPECT_FALSE(mill.controller.port().flood);
  const double x = mill.mm(0);
  mill.door(false);
  mill.machine().resume();
  mill.run(50);
  EXPECT_EQ(mill.substate(), 3);
  for (int left = 10'000; mill.machine().state() == MachineState::kDoor && left > 0; --left) {
    EXPECT_EQ(mill.mm(0), x);
    mill.run(1);
  }
  EXPECT_DOUBLE_EQ(mill.mm(2), -30.0);
  EXPECT_TRUE(mill.controller.port().spindle_enabled);
  EXPECT_TRUE(mill.controller.port().flood);
  mill.finish();
  EXPECT_DOUBLE_EQ(mill.mm(0), -10.0);
  EXPECT_EQ(mill.machine().alarm(), cnc::Alarm::kNone);
}

TEST(Parking, StaysWhereItIsAboveTheParkingPlace) {
  Mill mill;
  mill.door(true);
  mill.run(500);
  EXPECT_EQ(mill.substate(), 1);
  EXPECT_DOUBLE_EQ(mill.mm(2), -5.0);
}

/// The door opens and closes at random times; the job must end on the same steps.
TEST(Parking, AtAnyMomentLosesNoStep) {
  const Trials trials{25};
  for (const std::uint64_t seed : trials) {
    SCOPED_TRACE(testing::Message() << "KERFLINE_SEED=" << seed);
    Random random{seed};
    Mill mill;
    mill.send("M3 S500 F3000");
    for (int line = 0; line < 12; ++line) {
      mill.send("G1 X" + std::to_string(random.between(-55.0, -5.0)) + " Z" +
                std::to_string(random.between(-39.0, -8.0)));
      if (random.chance(0.4)) mill.run(static_cast<int>(random.below(500)));
      if (!random.chance(0.4)) continue;
      for (std::size_t slams = 1 + random.below(3); slams > 0; --slams) {
        mill.door(true);
        mill.run(static_cast<int>(random.below(2500)));
        mill.door(false);
        mill.machine().resume();
        mill.run(static_cast<int>(random.below(1500)));
      }
      for (int left = 100; mill.machine().state() == MachineState::kDoor && left > 0; --left) {
        mill.run(100);
        mill.machine().resume();
      }
    }
    mill.send("G1 X-20 Z-25");
    mill.finish();
    EXPECT_EQ(mill.machine().alarm(), cnc::Alarm::kNone);
    EXPECT_DOUBLE_EQ(mill.mm(0), -20.0);
    EXPECT_DOUBLE_EQ(mill.mm(2), -25.0);
    EXPECT_EQ(mill.motor(2), 250 * (3 - 25));
  }
}

}  // namespace
}  // namespace proof
