#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "tests/support/laser_settings.hpp"

namespace proof {
namespace {

constexpr double kRasterStepsPerMm = 80.0;

struct Timing {
  double on_us = 0.0;
  double off_us = 0.0;
  double lag_us = 0.0;
};

/// Stores all trace rows, so that the position at any time can be computed.
class RowLog final : public sim::TraceSink {
 public:
  void on_row(const sim::TraceRow& row) override { rows.push_back(row); }

  [[nodiscard]] std::int32_t x_at(double time_ns) const {
    const auto after = std::upper_bound(
        rows.begin(), rows.end(), time_ns, [](double time, const sim::TraceRow& row) {
          return time < static_cast<double>(row.time_ns);
        });
    return after == rows.begin() ? 0 : (after - 1)->position[0];
  }

  std::vector<sim::TraceRow> rows;
};

/// Strokes in both directions over the same dots of 0.5 mm, 1 mm apart, at 1 m/s.
constexpr int kDots = 6;
constexpr double kFirstDot = 60.0;
std::string raster() {
  std::string program = "G21 G90 M4 F60000 S0\n";
  for (int stroke = 0; stroke < 6; ++stroke) {
    const bool forward = stroke % 2 == 0;
    for (int i = 0; i < kDots; ++i) {
      const double low = kFirstDot + (forward ? i : kDots - 1 - i);
      const double from = forward ? low : low + 0.5;
      const double to = forward ? low + 0.5 : low;
      program += "G1 S0 X" + std::to_string(from) + "\nS600 X" + std::to_string(to) + "\n";
    }
    program += forward ? "S0 X126\n" : "S0 X0\n";
  }
  return program;
}

/// Expects that the beam goes on and off at the right steps on a machine whose delays are set.
void expect_dots_in_place(const Timing& timing) {
  sim::Simulator simulator{raster(), {}};
  set_up_laser(simulator, kRasterStepsPerMm, 1000.0, 20'000.0);
  EXPECT_EQ(simulator.change_setting(855, static_cast<float>(timing.on_us)), "");
  EXPECT_EQ(simulator.change_setting(856, static_cast<float>(timing.off_us)), "");
  EXPECT_EQ(simulator.change_setting(857, static_cast<float>(timing.lag_us)), "");
  RowLog log;
  simulator.add_sink(log);
  ASSERT_TRUE(simulator.run().refusals.empty());
  int edges = 0;
  bool was_lit = false;
  for (const sim::TraceRow& row : log.rows) {
    const bool is_lit = row.duty > 0.0F;
    if (is_lit == was_lit) continue;
    was_lit = is_lit;
    const double delay_us = timing.lag_us + (is_lit ? timing.on_us : timing.off_us);
    const double x = log.x_at(static_cast<double>(row.time_ns) + 1000.0 * delay_us);
    const double place = x / kRasterStepsPerMm - kFirstDot;
    const double off = place - 0.5 * std::round(2.0 * place);
    EXPECT_LE(std::abs(off) * kRasterStepsPerMm, 1.01) << "edge " << edges << " at " << place;
    ++edges;
  }
  EXPECT_EQ(edges, 6 * kDots * 2);
}

TEST(BeamTiming, DotsMeetInBothDirections) {
  expect_dots_in_place({});
  expect_dots_in_place({.lag_us = 700.0});
  expect_dots_in_place({.lag_us = -700.0});
  expect_dots_in_place({.lag_us = 4000.0});
  expect_dots_in_place({.lag_us = -4000.0});
}

TEST(BeamTiming, DotsKeepTheirLengthWithUnlikeDelays) {
  expect_dots_in_place({.on_us = 300.0});
  expect_dots_in_place({.off_us = 300.0});
  expect_dots_in_place({.on_us = 350.0, .off_us = 120.0, .lag_us = 200.0});
  expect_dots_in_place({.on_us = 120.0, .off_us = 350.0, .lag_us = -900.0});
}

/// The trace ends with the last step or later, and by then the beam must be off.
TEST(BeamTiming, IsDarkAtStandstillWhateverTheDelays) {
  for (const double lag : {-5000.0, -600.0, 600.0, 5000.0}) {
    for (const double delay : {0.0, 5000.0}) {
      sim::Simulator simulator{"G21 G91 M3 S900 F3000\nG1 X5\nG4 P0.05\nX-5\nY3\nG4 P0.05\n", {}};
      set_up_laser(simulator, kRasterStepsPerMm, 100.0, 1000.0);
      EXPECT_EQ(simulator.change_setting(855, static_cast<float>(delay)), "");
      EXPECT_EQ(simulator.change_setting(856, static_cast<float>(delay)), "");
      EXPECT_EQ(simulator.change_setting(857, static_cast<float>(lag)), "");
      RowLog log;
      simulator.add_sink(log);
      ASSERT_TRUE(simulator.run().refusals.empty());
      std::uint64_t last_step = 0;
      for (std::size_t i = 1; i < log.rows.size(); ++i) {
        const sim::TraceRow& row = log.rows[i];
        if (row.position != log.rows[i - 1].position) last_step = row.time_ns;
        // Near the slow ends of a row, steps are far apart; a longer gap between steps is a rest.
        constexpr std::uint64_t kRest = 12'000'000;
        if (row.time_ns > last_step + kRest && row.time_ns < last_step + 40'000'000) {
          EXPECT_EQ(row.duty, 0.0F) << lag << " " << delay;
        }
      }
      EXPECT_EQ(log.rows.back().duty, 0.0F);
    }
  }
}

}  // namespace
}  // namespace proof
