#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "tests/support/machine_bench.hpp"

namespace proof {
namespace {

using SettingValue = std::pair<int, double>;

/// Returns the time from the first line to standstill, ms.
int time_of(const std::vector<SettingValue>& settings, const std::vector<std::string>& lines) {
  MachineBench bench;
  bench.set(settings);
  for (const std::string& line : lines) bench.send(line);
  int time = 0;
  do {
    bench.run(1);
    ++time;
  } while ((bench.machine().busy() || !bench.machine().idle()) && time < 60'000);
  return time;
}

/// Sends lines and then nothing. The last line must be given out before the machine brakes for it,
/// so that the job takes no longer than with a dwell that marks its end.
void expect_no_braking(const std::vector<SettingValue>& settings, std::vector<std::string> lines) {
  const int silent = time_of(settings, lines);
  lines.emplace_back("G4 P0");
  EXPECT_NEAR(silent, time_of(settings, lines), 5);
}

TEST(SilentSender, CausesNoBrakingBeforeTheLastLine) {
  expect_no_braking({{120, 500.0}}, {"G21 G90 G1 F6000 X40", "X80"});
}

TEST(SilentSender, CausesNoneOnManyShortLines) {
  std::vector<std::string> lines{"G21 G91 G1 F6000 X20"};
  for (int i = 0; i < 40; ++i) lines.emplace_back("X0.2");
  lines.emplace_back("X60");
  expect_no_braking({{120, 500.0}}, lines);
}

// With a jerk limit, the plan is ahead of the motion and goes level before it brakes. At speeds of
// A²/J and above the window is A/J, whether the end is known at the start or not.
TEST(SilentSender, CausesNoneWhereJerkIsLimited) {
  for (const double speed : {1200.0, 3000.0, 6000.0}) {
    SCOPED_TRACE(speed);
    const std::vector<SettingValue> settings{{110, speed}, {120, 80.0}, {800, 320.0}};
    expect_no_braking(settings, {"G21 G90 G1 F6000 X40", "X80"});
  }
}

}  // namespace
}  // namespace proof
