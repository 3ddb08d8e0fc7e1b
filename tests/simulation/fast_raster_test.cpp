#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>
#include <vector>

#include "tests/simulation/raster_track.hpp"
#include "tests/support/machine_bench.hpp"

namespace proof {
namespace {

/// A row of narrow pixels as in an engraved picture, 48 powers per line of text, with long ends
/// without power.
struct FastRow {
  static constexpr int kPixels = 9600;
  static constexpr int kPowers = 48;
  static constexpr double kWidth = 0.02;
  /// Length of each end, mm. It suffices to reach full speed.
  static constexpr double kEnd = 30.0;
  static constexpr double kLast = kEnd + kWidth * kPixels;

  static int power(int pixel) { return 100 + (pixel * 37) % 900; }

  static std::vector<std::string> lines(double speed_mm_s) {
    std::vector<std::string> lines{fmt::format("G21 G90 M3 F{:.0f}", 60.0 * speed_mm_s),
                                   fmt::format("G1 X{:.1f} S0", kEnd)};
    for (int first = 0; first < kPixels; first += kPowers) {
      std::string line = fmt::format("X{:.4f}S", kEnd + kWidth * (first + kPowers));
      for (int i = first; i < first + kPowers; ++i) {
        line += fmt::format("{}{}", i > first ? ":" : "", power(i));
      }
      lines.push_back(line);
    }
    lines.push_back(fmt::format("G1 X{:.1f} S0", kEnd + kLast));
    return lines;
  }
};

/// Bytes per millisecond of a serial line at 1 Mbaud.
constexpr double kBytesPerTurn = 100.0;

/// Drives the row from a sender that sends `bytes_per_turn` in a millisecond into a buffer of 1
/// KiB.
RasterTrack stream_fast_row(double speed_mm_s, double bytes_per_turn = kBytesPerTurn) {
  constexpr double kBufferBytes = 1024.0;
  MachineBench bench;
  bench.set({{0, 1}, {32, 1}, {100, kRowStepsPerMm}, {110, 30'000}, {120, 5000}, {130, 600}});
  RasterTrack track;
  bench.controller.add_sink(track);
  double bytes = 0.0;
  for (const std::string& line : FastRow::lines(speed_mm_s)) {
    const auto size = static_cast<double>(line.size() + 1);
    for (; bytes < size || bench.machine().busy();
         bytes = std::min(bytes + bytes_per_turn, kBufferBytes)) {
      bench.run(1);
    }
    bytes -= size;
    bench.send(line);
  }
  bench.finish();
  EXPECT_EQ(bench.machine().alarm(), cnc::Alarm::kNone);
  return track;
}

/// Expects that groups of 48 pixels receive the programmed energy at any speed.
void expect_energy_of(const RasterTrack& track) {
  constexpr int kTogether = FastRow::kPowers;
  for (int first = 0; first + kTogether < FastRow::kPixels; first += kTogether) {
    double expected = 0.0;
    for (int i = first; i < first + kTogether; ++i) expected += 1.0e-3 * FastRow::power(i);
    const double from_s = time_at(track, FastRow::kEnd + FastRow::kWidth * first);
    const double to_s = time_at(track, FastRow::kEnd + FastRow::kWidth * (first + kTogether));
    const double driven = energy_between(track, from_s, to_s) / (to_s - from_s);
    EXPECT_NEAR(driven, expected / kTogether, 0.03 * expected / kTogether) << first;
  }
}

/// Returns the time at which the first motor passed a position, interpolated between two steps, s.
double time_between_steps(const RasterTrack& track, double mm) {
  const auto after = std::ranges::lower_bound(track.places, mm, {}, &RasterTrack::Place::mm);
  const auto before = after - 1;
  const double share = (mm - before->mm) / (after->mm - before->mm);
  return before->time_s + share * (after->time_s - before->time_s);
}

/// Expects that each pixel has its own power, to 3 % of it or to 1 % of full power, whichever is
/// greater.
void expect_energy_of_each_pixel(const RasterTrack& track) {
  double farthest = 0.0;
  for (int pixel = 0; pixel < FastRow::kPixels; ++pixel) {
    const double from_s = time_between_steps(track, FastRow::kEnd + FastRow::kWidth * pixel);
    const double to_s = time_between_steps(track, FastRow::kEnd + FastRow::kWidth * (pixel + 1));
    const double driven = energy_between(track, from_s, to_s) / (to_s - from_s);
    const double power = 1.0e-3 * FastRow::power(pixel);
    ASSERT_NEAR(driven, power, std::max(0.03 * power, 0.01)) << pixel;
    farthest = std::max(farthest, std::abs(driven - power));
  }
  std::printf("each pixel within %.2f %% of full power\n", 100.0 * farthest);
}

// The number of pixels that a serial line of 1 Mbaud can deliver.
TEST(Raster, OfTwentyThousandPixelsASecondKeepsItsFeedAndEachPower) {
  constexpr double kPixelsPerSecond = 20'000.0;
  const double speed = kPixelsPerSecond * FastRow::kWidth;
  const RasterTrack track = stream_fast_row(speed);
  const auto [least, most] = track.speeds_between(FastRow::kEnd, FastRow::kLast);
  std::printf("%.0f pixels a second: %.2f to %.2f mm/s\n", kPixelsPerSecond, least, most);
  EXPECT_GT(least, 0.999 * speed);
  EXPECT_LT(most, 1.001 * speed);
  expect_energy_of(track);
  expect_energy_of_each_pixel(track);
}

// With more pixels than the line delivers, the row becomes slower, but it neither stops nor changes
// its burn.
TEST(Raster, OfMorePixelsThanComeIsNeverStarved) {
  // Position from which on all lines received before the start have been driven, mm.
  constexpr double kFarFromStart = 110.0;
  constexpr double kFarFromEnd = 40.0;
  constexpr double kComing = 14'000.0;
  const RasterTrack track = stream_fast_row(20'000.0 * FastRow::kWidth, 0.6 * kBytesPerTurn);
  const auto [least, most] =
      track.speeds_between(FastRow::kEnd + kFarFromStart, FastRow::kLast - kFarFromEnd);
  std::printf("more pixels than come: driven at %.0f to %.0f in a second\n",
              least / FastRow::kWidth,
              most / FastRow::kWidth);
  EXPECT_GT(least, 0.9 * kComing * FastRow::kWidth);
  EXPECT_LT(most, 1.2 * kComing * FastRow::kWidth);
  expect_energy_of(track);
}

}  // namespace
}  // namespace proof
