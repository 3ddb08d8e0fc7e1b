#include <array>
#include <cmath>
#include <cstdio>
#include <optional>

#include "tests/firmware/controller_test.hpp"

namespace cnc {
namespace {

/// Returns half of the kerf in mm that 1800 W cut in 2 mm of CSP 1N (Park and Ahn 2007, Table 3, Q
/// in J/mm) at a speed in mm/s. The speed is limited to the range of the measured cuts (Table 2).
double half_kerf(double speed) {
  return 0.5 * (0.0061 * 1800.0 / std::clamp(speed, 50.0, 250.0 / 3.0) + 0.560);
}

constexpr double kProgrammed = 4000.0 / 60.0;

/// Tests G41 and G42 with the kerf of a material by the positions of the motors.
class MachineKerfTest : public ControllerTest {
 protected:
  MachineKerfTest() {
    const std::array<motion::PowerPoint, 1> points{{{10'000, 2'000'000}}};
    const auto table = motion::PowerTable::make(points);
    EXPECT_TRUE(table.ok());
    machine.set_power_table(table.value());
    send_all({"$32=1", "$11=0", "$120=1000", "$121=1000", "$100=1000", "$101=1000"});
    send_all({"$110=6000", "$111=6000"});
    send_all({"M190 P1 Q2", "G0 X15 Y8", "S900 F4000"});
    run_until_idle();
    sights.clear();
  }

  /// Cuts the edges of a hole from the waste inside, and moves out of the edge.
  void cut_hole() {
    send_all({"G1 X30 Y0", "Y20", "X0", "Y0", "X15"});
    send_all({"G40 G1 X15 Y8"});
    run_until_idle();
  }
  [[nodiscard]] double x_of(const Sight& sight) const { return sight.position[0] / 1000.0; }
  [[nodiscard]] double y_of(const Sight& sight) const { return sight.position[1] / 1000.0; }
  /// Returns the distance in mm to the nearest edge of the hole, positive inside.
  [[nodiscard]] double to_edge(const Sight& sight) const {
    const double x = x_of(sight);
    const double y = y_of(sight);
    return std::min({x, 30.0 - x, y, 20.0 - y});
  }

  /// Returns the speed in mm/s at a sight, over 5 ms; nothing at the ends.
  [[nodiscard]] std::optional<double> speed_at(std::size_t index) const {
    constexpr std::uint64_t kHalf = 10'000;  // ticks
    std::size_t from = index;
    std::size_t to = index;
    while (from > 0 && sights[index].tick - sights[from].tick < kHalf) --from;
    while (to + 1 < sights.size() && sights[to].tick - sights[index].tick < kHalf) ++to;
    const double ticks = static_cast<double>(sights[to].tick - sights[from].tick);
    if (ticks < 2.0 * kHalf) return std::nullopt;
    double way = 0.0;
    // Around a corner the path is longer than the chord.
    const Sight* last = &sights[from];
    for (const std::size_t next : {(from + index) / 2, index, (index + to) / 2, to}) {
      way += std::hypot(x_of(sights[next]) - x_of(*last), y_of(sights[next]) - y_of(*last));
      last = &sights[next];
    }
    return way / (ticks / 4.0e6);
  }
  /// Returns the greatest difference between the distance to the edge and half of the kerf at that
  /// speed.
  [[nodiscard]] double worst_edge() const {
    double worst = 0.0;
    for (std::size_t i = 0; i < sights.size(); ++i) {
      const Sight& sight = sights[i];
      // The speed around a corner belongs to neither edge.
      const bool corner = std::max(std::min(x_of(sight), 30.0 - x_of(sight)),
                                   std::min(y_of(sight), 20.0 - y_of(sight))) < 0.5;
      const bool entry_or_exit = std::abs(x_of(sight) - 15.0) < 3.0 && y_of(sight) < 10.0;
      if (sight.power == 0 || entry_or_exit || corner) continue;
      const auto speed = speed_at(i);
      if (speed) worst = std::max(worst, std::abs(to_edge(sight) - half_kerf(*speed)));
    }
    return worst;
  }
};

TEST_F(MachineKerfTest, KeepsTheKerfByThePowerOfTheSpeed) {
  send_all({"M3", "G41 G1 X15 Y0"});
  cut_hole();
  double least = 1.0e9;
  std::uint16_t weakest = 0xFFFF;
  for (const Sight& sight : sights) {
    if (sight.power == 0) continue;
    least = std::min(least, to_edge(sight));
    weakest = std::min(weakest, sight.power);
  }
  EXPECT_NEAR(least, half_kerf(kProgrammed), 0.001);
  EXPECT_LT(weakest, 3000) << "of 58982 at the programmed speed";
  EXPECT_NEAR(x_of(sights.back()), 15.0, 0.001);
  EXPECT_NEAR(y_of(sights.back()), 8.0, 0.001);
}

/// At the start of the exit the power still follows the speed, as constant power would burn this
/// point. The motions after the exit have the constant power of M3.
TEST_F(MachineKerfTest, KeepsItAtTheStartOfTheExit) {
  send_all({"M3", "G41 G1 X15 Y0"});
  cut_hole();
  std::uint16_t least = 0xFFFF;
  for (const Sight& sight : sights) {
    if (sight.power > 0 && std::abs(x_of(sight) - 15.0) < 0.01 && y_of(sight) > 1.0) {
      least = std::min(least, sight.power);
    }
  }
  EXPECT_LT(least, 20'000) << "of 58982 at the programmed speed";
  sights.clear();
  send("G1 X20");
  run_until_idle();
  for (const Sight& sight : sights) {
    EXPECT_TRUE(sight.power == 0 || sight.power > 50'000) << sight.power;
  }
}

TEST_F(MachineKerfTest, OrFollowsIt) {
  send_all({"$860=1", "M3", "G41 G1 X15 Y0"});
  cut_hole();
  EXPECT_LT(worst_edge(), 0.005);
  EXPECT_NEAR(x_of(sights.back()), 15.0, 0.001);
  EXPECT_NEAR(y_of(sights.back()), 8.0, 0.001);
  EXPECT_EQ(machine.interpreter().position(), machine.motion().target());
}

TEST_F(MachineKerfTest, AlsoWhereTheFeedIsOverridden) {
  for (const char* change : {"\x92\x92\x92\x92\x92", "\x91\x91\x91\x91\x91"}) {
    sights.clear();
    send_all({"$860=1", "M3", "G41 G1 X15 Y0"});
    stream("\x90");
    stream(change);
    cut_hole();
    EXPECT_LT(worst_edge(), 0.005);
    EXPECT_NEAR(y_of(sights.back()), 8.0, 0.001);
  }
}

TEST_F(MachineKerfTest, RoundACircleToo) {
  send_all({"$860=1", "M3", "G41 G1 X20 Y8", "G3 X20 Y8 I-5", "G40 G1 X16 Y8"});
  run_until_idle();
  double worst = 0.0;
  for (std::size_t i = 0; i < sights.size(); ++i) {
    const double x = x_of(sights[i]) - 15.0;
    const double y = y_of(sights[i]) - 8.0;
    if (sights[i].power == 0 || (x > 0.0 && std::abs(y) < 1.0)) continue;
    const auto speed = speed_at(i);
    if (speed) worst = std::max(worst, std::abs(5.0 - std::hypot(x, y) - half_kerf(*speed)));
  }
  EXPECT_LT(worst, 0.005);
}

/// At three quarters of the feed the motors run beside the plan along the complete path, including
/// joints.
TEST_F(MachineKerfTest, PastTheJointsOfArcs) {
  send_all({"$860=1", "M3", "G41 G1 X20 Y8", "G3 X15 Y13 I-5", "G3 X15 Y3 J-5", "G3 X20 Y8 J5"});
  send_all({"G3 X15 Y13 I-5", "G40 G1 X15 Y11"});
  stream("\x90\x92\x92");
  stream("\x94\x94\x94\x94\x94");
  run_until_idle();
  double worst = 0.0;
  for (std::size_t i = 0; i < sights.size(); ++i) {
    const double x = x_of(sights[i]) - 15.0;
    const double y = y_of(sights[i]) - 8.0;
    if (sights[i].power == 0 || (x > -1.0 && y > -1.0)) continue;
    const auto speed = speed_at(i);
    if (speed) worst = std::max(worst, std::abs(5.0 - std::hypot(x, y) - half_kerf(*speed)));
  }
  EXPECT_LT(worst, 0.005);
}

/// The corners of the hole are exactly where they are drawn.
TEST_F(MachineKerfTest, MeetsTheShiftedWayBehindACorner) {
  send_all({"$860=1", "M3", "G41 G1 X15 Y0"});
  cut_hole();
  const double slow = half_kerf(0.0);
  for (const auto& [x, y] : {std::pair{0.0, 0.0}, {30.0, 0.0}, {30.0, 20.0}, {0.0, 20.0}}) {
    double least = 1.0e9;
    for (const Sight& sight : sights) {
      const double inwards_x = std::abs(x_of(sight) - x);
      const double inwards_y = std::abs(y_of(sight) - y);
      least = std::min(least, std::hypot(inwards_x - slow, inwards_y - slow));
    }
    EXPECT_LT(least, 0.003) << x << ", " << y;
  }
  for (const Sight& sight : sights) {
    if (sight.power == 0) continue;
    EXPECT_GT(to_edge(sight), half_kerf(kProgrammed) - 0.002);
  }
}

TEST_F(MachineKerfTest, AHoldRestsBesideThePathAndGoesOn) {
  send_all({"$860=1", "M3", "G41 G1 X15 Y0", "G1 X30 Y0", "Y20", "X0", "Y0", "X15"});
  send_all({"G40 G1 X15 Y8"});
  run(500);
  stream("!");
  run(500);
  EXPECT_EQ(report().substr(0, 7), "<Hold:0");
  EXPECT_EQ(port.power, 0);
  stream("~");
  run_until_idle();
  EXPECT_NEAR(x_of(sights.back()), 15.0, 0.001);
  EXPECT_NEAR(y_of(sights.back()), 8.0, 0.001);
}

TEST_F(MachineKerfTest, AResetBesideThePathLosesNoPlace) {
  send_all({"$860=1", "M3", "G41 G1 X15 Y0", "G1 X30 Y0", "Y20", "X0", "Y0", "X15"});
  send_all({"G40 G1 X15 Y8"});
  run(500);
  stream("!");
  run(500);
  stream("\x18");
  run(20);
  send_all({"$X", "G90 G0 X1 Y1"});
  run_until_idle();
  EXPECT_EQ(port.position[0], 1000);
  EXPECT_EQ(port.position[1], 1000);
}

}  // namespace
}  // namespace cnc
