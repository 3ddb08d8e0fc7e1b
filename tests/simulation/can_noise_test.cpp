#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdio>
#include <string>
#include <vector>

#include "tests/support/can_bench.hpp"
#include "tests/support/random_source.hpp"

namespace proof {
namespace {

/// Returns a laser job of short lines and arcs. Its beginning is held until the look-ahead is full.
std::vector<std::string> job(std::size_t lines) {
  std::vector<std::string> text{"G21 G91 M4 S500 F3000"};
  Random random{7};
  for (std::size_t n = 0; n < lines; ++n) {
    char line[64];
    if (n % 5 == 4) {
      std::snprintf(line, sizeof line, "G2 X%.3f I%.3f", 1.0, 0.5);
    } else {
      std::snprintf(line,
                    sizeof line,
                    "G1 X%.3f Y%.3f",
                    random.between(-0.4, 0.8),
                    random.between(-0.5, 0.5));
    }
    text.emplace_back(line);
  }
  return text;
}

/// Returns the edges from a time on, with times relative to the first edge: delays of a sender
/// shift all edges alike.
std::vector<sim::TraceRow> edges_from(std::uint64_t time_ns, std::vector<sim::TraceRow> rows) {
  std::erase_if(rows, [&](const sim::TraceRow& row) { return row.time_ns < time_ns; });
  const std::uint64_t begin_ns = rows.empty() ? 0 : rows.front().time_ns;
  for (sim::TraceRow& row : rows) row.time_ns -= begin_ns;
  return rows;
}

bool same(const sim::TraceRow& a, const sim::TraceRow& b) {
  return a.time_ns == b.time_ns && a.position == b.position && a.duty == b.duty;
}

/// Runs a job on a disturbed bus. The look-ahead is full before motion begins. So the motion must
/// not depend on when a line arrives, as long as lines arrive faster than they are driven.
class DisturbedBus : public testing::TestWithParam<int> {
 protected:
  static std::vector<sim::TraceRow> drive(CanBench& bench, double share) {
    bench.bus.disturb(share);
    bench.add(0x11);
    bench.sender().lines = job(1500);
    bench.sender().lines.insert(bench.sender().lines.begin(), {"$32=1", "G1 X0.1 F60"});
    const auto state = [&] { return bench.station().machine().state(); };
    for (int n = 0; n < 1000 && state() != cnc::MachineState::kRun; ++n) bench.turn();
    bench.sender().act("!");
    bench.turns(3000);
    EXPECT_EQ(state(), cnc::MachineState::kHold);
    bench.sender().act("~");
    const std::uint64_t begun_ns = bench.now_ns;
    bench.finish();
    EXPECT_TRUE(bench.sender().errors.empty());
    EXPECT_EQ(bench.station().machine().alarm(), cnc::Alarm::kNone);
    return edges_from(begun_ns, bench.station().edges.rows);
  }
};

TEST_P(DisturbedBus, DrivesTheSameStepsAtTheSameTimes) {
  CanBench quiet;
  const std::vector<sim::TraceRow> wanted = drive(quiet, 0.0);
  CanBench noisy;
  const std::vector<sim::TraceRow> found = drive(noisy, GetParam() / 100.0);
  const hal::CanHealth health = noisy.station().place.health();
  std::printf(
      "%d %% disturbed: %llu frames passed, %llu did not, bus-off %u and %u times; %zu edges\n",
      GetParam(),
      static_cast<unsigned long long>(noisy.bus.frames()),
      static_cast<unsigned long long>(noisy.bus.disturbed()),
      health.bus_offs,
      noisy.sender().place.health().bus_offs,
      found.size());
  EXPECT_GT(wanted.size(), 10'000U);
  ASSERT_EQ(found.size(), wanted.size());
  const auto [a, b] = std::mismatch(found.begin(), found.end(), wanted.begin(), same);
  EXPECT_TRUE(a == found.end()) << "at " << a->time_ns << " instead of " << b->time_ns;
}

INSTANTIATE_TEST_SUITE_P(Shares, DisturbedBus, testing::Values(0, 5, 10, 30));

}  // namespace
}  // namespace proof
