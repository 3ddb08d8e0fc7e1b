#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>

#include "tests/support/laser_settings.hpp"
#include "tests/support/random_source.hpp"
#include "tests/support/trials.hpp"

namespace proof {
namespace {

/// Records the time of the last edge.
class LastEdge final : public sim::TraceSink {
 public:
  void on_row(const sim::TraceRow& row) override {
    if (row.position != last_.position) last_ = row;
  }
  [[nodiscard]] double seconds() const { return static_cast<double>(last_.time_ns) * 1.0e-9; }

 private:
  sim::TraceRow last_{};
};

double now(const sim::Simulator& simulator) {
  return static_cast<double>(simulator.now_ticks()) / cnc::motion::kTicksPerSecond;
}

/// Returns the time that a hold in the middle of a long line takes beyond v/a, s.
double hold_delay(std::uint64_t seed) {
  constexpr double kQueue = 0.021;  // Segments of 20 ms and the cycle that notices the hold, s.
  Random random{seed};
  const double speed = random.magnitude(10.0, 200.0);
  const double acceleration = random.magnitude(100.0, 5000.0);
  sim::Simulator simulator{"G21 G90\nG1 X700 F" + std::to_string(60.0 * speed) + "\nM2\n", {}};
  set_up_laser(simulator, 80.0, 1.1 * speed, acceleration);
  LastEdge edge;
  simulator.add_sink(edge);
  const double hold_at = speed / acceleration + random.between(0.03, 1.0);
  while (now(simulator) < hold_at) simulator.turn();
  const double held_at = now(simulator);
  simulator.machine().feed_hold();
  for (int turn = 0; turn < 3000; ++turn) simulator.turn();
  EXPECT_TRUE(simulator.machine().motion().halted());
  const double took = edge.seconds() - held_at;
  const double ramp = speed / acceleration;
  EXPECT_LE(took, 1.02 * ramp + kQueue) << "v " << speed << ", a " << acceleration;
  EXPECT_GE(took, 0.9 * ramp) << "harder than the axis may";
  simulator.machine().resume();
  for (int turn = 0; turn < kMaxTurns && !simulator.done(); ++turn) simulator.turn();
  EXPECT_EQ(simulator.result().final_position[0], 700 * 80);
  return took - ramp;
}

TEST(FeedHold, StopsALongLineAtTheLimitOfTheAxis) {
  const Trials trials{60};
  double longest = 0.0;
  for (const std::uint64_t seed : trials) {
    SCOPED_TRACE(testing::Message() << "KERFLINE_SEED=" << seed);
    longest = std::max(longest, hold_delay(seed));
  }
  std::printf("feed hold: at most %.1f ms beyond v/a\n", 1.0e3 * longest);
}

void hold_line_at(std::size_t turns, double speed, double acceleration) {
  sim::Simulator simulator{"G21 G90\nG1 X10 Y3 F" + std::to_string(60.0 * speed) + "\nM2\n", {}};
  set_up_laser(simulator, 160.0, 2.0 * speed, acceleration);
  for (std::size_t turn = 0; turn < turns; ++turn) simulator.turn();
  simulator.machine().feed_hold();
  for (int turn = 0; turn < 1000; ++turn) simulator.turn();
  simulator.machine().resume();
  for (int turn = 0; turn < 5000 && !simulator.done(); ++turn) simulator.turn();
  EXPECT_EQ(simulator.result().alarm, 0);
  EXPECT_EQ(simulator.result().final_position[0], 1600);
}

// The hold may come while the machine already brakes for the end of the motion. Each line is held
// at every seventh millisecond; the first one shifts from line to line, so that every seventh line
// has the same ones.
TEST(FeedHold, AtAnyMillisecondOfALineLosesNothing) {
  constexpr std::size_t kApart = 7;
  const Trials trials{105};
  for (const std::uint64_t seed : trials) {
    Random random{seed};
    const double speed = random.magnitude(10.0, 100.0);
    const double acceleration = random.magnitude(100.0, 5000.0);
    for (auto turns = seed % kApart; turns < 600 && !too_many_failures(); turns += kApart) {
      SCOPED_TRACE(testing::Message() << "KERFLINE_SEED=" << seed << ", v " << speed << ", a "
                                      << acceleration << ", hold at " << turns << " ms");
      hold_line_at(turns, speed, acceleration);
    }
  }
}

}  // namespace
}  // namespace proof
