#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <sstream>
#include <string>
#include <vector>

#include "tests/simulation/raster_track.hpp"
#include "tests/support/beam_run.hpp"
#include "tests/support/machine_bench.hpp"

namespace proof {
namespace {

/// Returns a power S between 50 and 1000 that hardly ever repeats.
int grey(int pixel, int row = 0) { return 50 + (pixel * 370 + row * 110) % 951; }

/// Returns rows of pixels in alternating directions, 0.1 mm apart.
std::string picture(int rows, int pixels, double width_mm, double feed_mm_s, char mode) {
  std::string text = fmt::format("G21 G90 M{} F{:.0f} S0\n", mode, 60.0 * feed_mm_s);
  for (int row = 0; row < rows; ++row) {
    if (row > 0) text += fmt::format("G1 Y{:.1f} S0\n", 0.1 * row);
    for (int i = 1; i <= pixels; ++i) {
      const int pixel = row % 2 == 0 ? i : pixels - i;
      text += fmt::format("G1 X{:.4f} S{}\n", width_mm * pixel, grey(i, row));
    }
  }
  return text;
}

struct RasterRun {
  sim::RunResult result{};
  RasterTrack track{};
};

RasterRun run_raster(const std::string& program, double speed, double acceleration) {
  sim::Simulator simulator{program, {}};
  set_up_laser(simulator, kRowStepsPerMm, speed, acceleration);
  EXPECT_EQ(simulator.change_setting(0, 1.0F), "");
  RasterRun run;
  simulator.add_sink(run.track);
  run.result = simulator.run();
  EXPECT_TRUE(run.result.refusals.empty());
  EXPECT_EQ(run.result.alarm, 0);
  return run;
}

/// Drives a row of 0.1 mm pixels at 300 mm/s from a sender of `lines_per_turn` lines in each
/// millisecond.
RasterTrack stream_row(int pixels, int lines_per_turn, std::size_t& blocks) {
  MachineBench bench;
  bench.set({{0, 1}, {32, 1}, {100, kRowStepsPerMm}, {110, 24'000}, {120, 3000}});
  RasterTrack track;
  bench.controller.add_sink(track);
  bench.send("G21 G90 M4 F18000 S0");
  int sent = 0;
  for (int turn = 0; turn < kMaxTurns && sent < pixels; ++turn) {
    for (int line = 0; line < lines_per_turn && sent < pixels && !bench.machine().busy(); ++line) {
      ++sent;
      bench.send(fmt::format("G1 X{:.1f} S{}", 0.1 * sent, grey(sent)));
    }
    bench.run(1);
  }
  bench.finish();
  EXPECT_NEAR(bench.mm(0), 0.1 * pixels, 1.0e-6);
  blocks = bench.machine().motion().blocks_taken();
  return track;
}

// The look-ahead always contains twice the braking distance from 300 mm/s.
TEST(Raster, OfATenthOfAMillimetreDoesNotSlowDownAt300MillimetresPerSecond) {
  constexpr int kPixels = 20'000;
  constexpr double kRamp = 300.0 * 300.0 / (2.0 * 3000.0);
  std::size_t blocks = 0;
  const RasterTrack track = stream_row(kPixels, 64, blocks);
  const auto [least, most] = track.speeds_between(kRamp + 0.5, 0.1 * kPixels - kRamp - 0.5);
  std::printf("row of %d pixels at 300 mm/s: %.2f to %.2f mm/s, %zu blocks\n",
              kPixels,
              least,
              most,
              blocks);
  EXPECT_GT(least, 299.9);
  EXPECT_LT(most, 300.1);
  EXPECT_LE(blocks, kPixels / 12U);
}

// A slow sender must make the row slower evenly, without alternation between fast and slow.
TEST(Raster, GoesAsFastAsASlowSenderAllows) {
  constexpr int kPixels = 6000;
  for (const int lines : {1, 2}) {
    std::size_t blocks = 0;
    const RasterTrack track = stream_row(kPixels, lines, blocks);
    const double supply = 100.0 * lines;
    const auto [least, most] = track.speeds_between(0.3 * supply, 0.1 * kPixels - 30.0);
    std::printf("row of pixels at %d lines/ms: %.1f to %.1f mm/s, %zu blocks\n",
                lines,
                least,
                most,
                blocks);
    EXPECT_GT(least, 0.8 * supply);
    EXPECT_LT(most, 1.2 * supply);
  }
}

// With constant power, each change of the output is the border of a pixel.
TEST(Raster, ChangesPowerWhereTheProgramDoes) {
  constexpr int kPixels = 600;
  for (const double speed : {50.0, 100.0, 300.0}) {
    SCOPED_TRACE(speed);
    const RasterRun run = run_raster(picture(1, kPixels, 0.1, speed, '3'), 400.0, 3000.0);
    ASSERT_EQ(run.track.changes.size(), kPixels + 1U);
    double farthest = 0.0;
    for (std::size_t i = 1; i < kPixels; ++i) {
      const auto place = run.track.place_at(run.track.changes[i].time_s);
      ASSERT_TRUE(place.has_value());
      farthest = std::max(farthest, std::abs(*place - 0.1 * static_cast<double>(i)));
      EXPECT_NEAR(run.track.changes[i].duty, 0.001 * grey(static_cast<int>(i) + 1), 1.0e-4);
    }
    std::printf(
        "pixels at %.0f mm/s: at most %.2f um from their places\n", speed, 1.0e3 * farthest);
    EXPECT_LT(farthest, 0.25 / kRowStepsPerMm);
  }
}

/// Returns the positions at which the output changed between the ends of a row, mm. `first` is the
/// change at the row's beginning.
std::vector<double> places_of_changes(const RasterTrack& track, std::size_t first, int pixels) {
  std::vector<double> places;
  for (int i = 1; i < pixels; ++i) {
    const auto place = track.place_at(track.changes[first + static_cast<std::size_t>(i)].time_s);
    EXPECT_TRUE(place.has_value()) << i;
    places.push_back(place.value_or(-1.0));
  }
  return places;
}

// In rows to the right and to the left, each border of two pixels must be at its drawn position.
TEST(Raster, HasItsDotsInTheSamePlaceInBothDirections) {
  constexpr int kPixels = 600;
  constexpr double kRowStepMm = 1.0 / kRowStepsPerMm;
  for (const double speed : {50.0, 100.0, 300.0}) {
    SCOPED_TRACE(speed);
    const RasterRun run = run_raster(picture(2, kPixels, 0.1, speed, '3'), 400.0, 3000.0);
    ASSERT_EQ(run.track.changes.size(), 2 * (kPixels + 1U));
    const auto right = places_of_changes(run.track, 0, kPixels);
    auto left = places_of_changes(run.track, kPixels + 1U, kPixels);
    std::ranges::reverse(left);
    double farthest = 0.0;
    for (std::size_t i = 0; i < right.size(); ++i) {
      farthest = std::max(farthest, std::abs(right[i] - left[i]));
      EXPECT_NEAR(left[i], 0.1 * static_cast<double>(i + 1), 0.5 * kRowStepMm) << i;
    }
    std::printf(
        "rows to and fro at %.0f mm/s: dots at most %.2f um apart\n", speed, 1.0e3 * farthest);
    EXPECT_LT(farthest, kRowStepMm);
  }
}

TEST(Raster, GivesEachPixelItsEnergy) {
  for (const double acceleration : {500.0, 3000.0}) {
    for (const double speed : {30.0, 100.0, 200.0}) {
      SCOPED_TRACE(testing::Message() << speed << " mm/s, " << acceleration << " mm/s²");
      const BeamRun run{.speed = 300.0, .acceleration = acceleration};
      const auto figures = run.measure(picture(2, 400, 0.1, speed, '4'));
      std::printf("pixels at %.0f mm/s, %.0f mm/s2: any 0.05 mm %.4f to %.4f, mean %.4f\n",
                  speed,
                  acceleration,
                  figures.least,
                  figures.greatest,
                  figures.mean);
      EXPECT_GT(figures.windows, 1000U);
      EXPECT_GT(figures.least, 0.97);
      EXPECT_LT(figures.greatest, 1.03);
      EXPECT_NEAR(figures.mean, 1.0, 0.002);
    }
  }
}

TEST(Raster, IsOneMotionInAnyMode) {
  const std::string text = picture(1, 300, 0.1, 100.0, '4');
  for (const char* const mode : {"G61\n", "G61.1\n", "G64 P0.1\n"}) {
    const RasterRun run = run_raster(mode + text, 300.0, 1000.0);
    EXPECT_GT(run.track.speeds_between(6.0, 24.0).first, 99.9) << mode;
    EXPECT_LE(run.result.blocks, 60U) << mode;
  }
}

// Many powers in a line as LightBurn writes them, here along a diagonal.
TEST(Raster, MayBeWrittenWithManyPowersInALine) {
  constexpr int kPixels = 640;
  std::string many = "G21 G91 M4 F6000 S0\n";
  for (int pixel = 0; pixel < kPixels;) {
    const int count = std::min(1 + pixel % 20, kPixels - pixel);
    many += fmt::format("G1 X{:.1f} Y{:.1f} S{}", 0.2 * count, 0.1 * count, grey(pixel));
    for (int i = 1; i < count; ++i) many += fmt::format(":{}", grey(pixel + i));
    many += "\n";
    pixel += count;
  }
  const BeamRun run{.acceleration = 2000.0};
  const auto figures = run.measure(many);
  std::printf("many powers in a line: any 0.05 mm %.4f to %.4f, mean %.4f\n",
              figures.least,
              figures.greatest,
              figures.mean);
  EXPECT_GT(figures.least, 0.97);
  EXPECT_LT(figures.greatest, 1.03);
  EXPECT_NEAR(figures.mean, 1.0, 0.002);
  EXPECT_GT(figures.windows, 10'000U);
  const RasterRun whole = run_raster(many, 200.0, 2000.0);
  EXPECT_LE(whole.result.job_time_s, 0.2236 * kPixels / 100.0 + 0.12);
  EXPECT_LE(whole.result.blocks, kPixels / 6U);
}

TEST(Raster, TellsTheLineOfThePixelBeingDriven) {
  MachineBench bench;
  bench.set({{32, 1}, {110, 6000}});
  bench.send("G21 G91 F600 M4");
  constexpr int kPixels = 60;
  int sent = 0;
  std::uint32_t last = 0;
  std::vector<std::uint32_t> seen;
  for (int left = 5000; left > 0 && last < kPixels; --left) {
    if (sent < kPixels && !bench.machine().busy()) {
      ++sent;
      bench.send(fmt::format("N{} G1 X0.5 S{}", sent, grey(sent)));
    }
    bench.run(1);
    const std::uint32_t line = bench.machine().motion().line_in_execution();
    if (line == last || line == 0) continue;
    EXPECT_EQ(line, last + 1);
    last = line;
    // Segments are cut at most some 20 ms ahead of the motors.
    EXPECT_NEAR(bench.mm(0), 0.5 * (line - 1), 0.3) << "line " << line;
  }
  EXPECT_EQ(last, kPixels * 1U);
  bench.finish();
}

/// A row with long ends, with pixels so narrow that 25,000 pass in a second.
struct FineRow {
  static constexpr int kPixels = 1200;
  static constexpr double kWidth = 0.02;
  static constexpr double kSpeed = 500.0;
  /// Length of each end, mm. It suffices to reach full speed.
  static constexpr double kEnd = 40.0;

  static int power(int pixel) { return pixel % 3 == 0 ? 0 : grey(pixel); }

  static std::string program() {
    std::string text = fmt::format("G21 G90 M3 F{:.0f}\nG1 X{:.1f} S0\n", 60.0 * kSpeed, kEnd);
    for (int i = 1; i <= kPixels; ++i) {
      text += fmt::format("G1 X{:.3f} S{}\n", kEnd + kWidth * i, power(i));
    }
    return text + fmt::format("G1 X{:.1f} S0\n", 2.0 * kEnd + kWidth * kPixels);
  }
};

// Pixels may follow each other faster than segments can. Such a row must not starve the step
// interrupt, and must keep its energy.
TEST(Raster, OfPixelsFasterThanSegmentsIsDrivenWithTheirEnergy) {
  constexpr int kTogether = 50;
  constexpr double kLongestJoined_s = 2.0e-4;
  for (const double shaper : {0.0, 1.0}) {
    MachineBench bench;
    bench.set({{0, 1}, {32, 1}, {100, kRowStepsPerMm}, {110, 30'000}, {120, 6000}, {130, 300}});
    bench.set({{cnc::setting::kShaper, shaper}, {cnc::setting::kShaperFrequency, 60.0}});
    RasterTrack track;
    bench.controller.add_sink(track);
    std::istringstream lines{FineRow::program()};
    for (std::string line; std::getline(lines, line);) bench.send(line);
    bench.finish();
    EXPECT_EQ(bench.machine().alarm(), cnc::Alarm::kNone);
    for (int first = 1; first + kTogether <= FineRow::kPixels; first += kTogether) {
      double expected = 0.0;
      for (int i = first; i < first + kTogether; ++i) expected += 1.0e-3 * FineRow::power(i);
      const double from_s = time_at(track, FineRow::kEnd + FineRow::kWidth * (first - 1));
      const double to_s = time_at(track, FineRow::kEnd + FineRow::kWidth * (first - 1 + kTogether));
      const double driven = energy_between(track, from_s, to_s);
      EXPECT_NEAR(driven, expected * (to_s - from_s) / kTogether, kLongestJoined_s) << first;
    }
  }
}

// After an aborted row, nothing of it may remain in the next row.
TEST(Raster, LeavesNothingBehindWhenItIsCutOff) {
  MachineBench bench;
  bench.set({{32, 1}, {110, 6000}});
  RasterTrack track;
  for (int round = 0; round < 12; ++round) {
    bench.send("G21 G90 F6000 M3 S0");
    bench.send("G1 X0");
    bench.finish();
    for (int i = 1; i <= 400; ++i) bench.send(fmt::format("G1 X{:.1f} S{}", 0.1 * i, grey(i)));
    bench.run(7 + 23 * round);
    bench.machine().feed_hold();
    bench.run(200);
    bench.machine().reset();
    bench.run(50);
    static_cast<void>(bench.machine().unlock());
    EXPECT_EQ(bench.machine().motion().blocks(), 0U);
  }
  bench.send("G21 G90 F6000 M3 S0");
  bench.send("G1 X0");
  bench.finish();
  bench.controller.add_sink(track);
  bench.send("G1 X10 S500");
  for (int i = 1; i <= 40; ++i)
    bench.send(fmt::format("G1 X{:.1f} S{}", 10.0 + 0.1 * i, i % 2 * 500));
  bench.finish();
  for (const auto& change : track.changes) {
    EXPECT_TRUE(change.duty == 0.0F || std::abs(change.duty - 0.5F) < 1.0e-4F) << change.duty;
  }
  EXPECT_EQ(track.changes.size(), 40U) << "the last pixel is dark";
}

}  // namespace
}  // namespace proof
