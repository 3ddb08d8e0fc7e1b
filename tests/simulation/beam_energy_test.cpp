#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <string>

#include "tests/support/beam_run.hpp"
#include "tests/support/random_source.hpp"
#include "tests/support/trials.hpp"

namespace proof {
namespace {

constexpr double kTolerance = 0.03;  ///< Greatest error of the energy of any 0.05 mm, as a share.

std::string feed_word(double mm_s) { return "F" + std::to_string(60.0 * mm_s) + "\n"; }

void expect_even(const sim::EnergyFigures& figures) {
  EXPECT_GT(figures.windows, 100U);
  EXPECT_GT(figures.least, 1.0 - kTolerance) << "at " << figures.min_at_mm << " mm";
  EXPECT_LT(figures.greatest, 1.0 + kTolerance) << "at " << figures.greatest_at_mm << " mm";
  EXPECT_NEAR(figures.mean, 1.0, 0.002);
}

/// A path with starts, ends, sharp and blunt corners, arcs of many sizes.
constexpr const char* kShapes =
    "G1 X20 Y0\nX20 Y15\nX10 Y15\nX13 Y3\nX2 Y14\nX0 Y0\n"
    "X3 Y0.3\nX6 Y0\nX9 Y0.9\nG4 P0.01\nG1 X4 Y0\nG3 X4 Y10 I0 J5\nG2 X12 Y10 I4 J0\n"
    "G2 X12.8 Y10 I0.4 J0\nG3 X12.8 Y10 I-0.3\nG1 X0 Y0\n";

class BeamEnergy : public testing::TestWithParam<double> {};

TEST_P(BeamEnergy, IsTheSameOverAnyTwentiethOfAMillimetre) {
  for (const double acceleration : {500.0, 3000.0}) {
    SCOPED_TRACE(acceleration);
    const BeamRun run{.acceleration = acceleration};
    const auto figures = run.measure("G21 G90 M4 S700\n" + feed_word(GetParam()) + kShapes);
    std::printf("energy per mm at %.0f mm/s, %.0f mm/s2: %.4f to %.4f of programmed, mean %.4f\n",
                GetParam(),
                acceleration,
                figures.least,
                figures.greatest,
                figures.mean);
    expect_even(figures);
  }
}

INSTANTIATE_TEST_SUITE_P(Speeds, BeamEnergy, testing::Values(10.0, 30.0, 80.0, 200.0));

TEST(BeamEnergyOfM3, GrowsWhereTheMachineIsSlow) {
  const auto figures = BeamRun{}.measure("G21 G90 M3 S700 F6000\nG1 X20\nY10\n");
  EXPECT_NEAR(figures.least, 1.0, kTolerance);
  EXPECT_GT(figures.greatest, 5.0);
}

/// Random strokes and arcs at varying feeds and powers, separated by stretches with the beam off.
TEST(BeamEnergyOfM4, HoldsOnRandomPrograms) {
  const Trials trials{12};
  double least = 1.0;
  double greatest = 1.0;
  for (const std::uint64_t seed : trials) {
    SCOPED_TRACE(testing::Message() << "KERFLINE_SEED=" << seed);
    Random random{seed};
    std::string program = "G21 G91 M4 F3000\n";
    for (int line = 0; line < 60; ++line) {
      if (random.chance(0.3)) program += feed_word(random.between(10.0, 200.0));
      if (random.chance(0.3)) program += "S" + std::to_string(random.between(100.0, 1000.0)) + "\n";
      const std::string x = std::to_string(random.between(-8.0, 8.0));
      const std::string y = std::to_string(random.between(-8.0, 8.0));
      program += random.chance(0.2)   ? "G0"
                 : random.chance(0.3) ? "G2 R" + std::to_string(random.between(6.0, 30.0))
                                      : "G1";
      program += " X" + x + " Y" + y + "\n";
    }
    const BeamRun run{.acceleration = random.between(500.0, 3000.0)};
    SCOPED_TRACE(program);
    const auto figures = run.measure(program);
    expect_even(figures);
    least = std::min(least, figures.least);
    greatest = std::max(greatest, figures.greatest);
  }
  std::printf("energy per mm on random programs: %.4f to %.4f of programmed\n", least, greatest);
}

/// Returns rows in both directions of 0.1 mm pixels, dim ones next to bright ones. A tick of 250 ns
/// at 470 mm/s is 0.12 µm. Next to a pixel that is 50 times as bright, this makes up to 1.2 % of
/// the energy of 0.05 mm.
std::string rows_of_pixels(double mm_s, Random& random) {
  constexpr int kPixels = 1000;
  std::string program = "G21 G90 M4 S0\nG0 X20\n" + feed_word(mm_s);
  for (int row = 0; row < 4; ++row) {
    program += "G1 Y" + std::to_string(0.1 * row) + " S0\n";
    for (int i = 1; i <= kPixels; ++i) {
      const int pixel = row % 2 == 0 ? i : kPixels - i;
      const int power = random.chance(0.3) ? 20 : 50 + static_cast<int>(random.below(951));
      program += "G1 X" + std::to_string(20.0 + 0.1 * pixel) + " S" + std::to_string(power) + "\n";
    }
    program += row % 2 == 0 ? "G1 X140 S0\n" : "G1 X0 S0\n";
  }
  return program;
}

/// Steps of a K40 at 75 kHz with pulses of 10 µs: power has hardly time to change between two
/// pulses.
TEST(BeamEnergyOfM4, HoldsInAFastRasterWhateverThePulses) {
  for (const double pulse_us : {1.0, 5.0, 10.0}) {
    for (const std::uint64_t seed : Trials{2}) {
      SCOPED_TRACE(testing::Message() << "KERFLINE_SEED=" << seed);
      Random random{seed};
      const BeamRun run{.steps_per_mm = 160.0,
                        .speed = 500.0,
                        .acceleration = 3500.0,
                        .settings = {{0, pulse_us}}};
      const auto figures = run.measure(rows_of_pixels(470.0, random));
      std::printf("energy per mm in a raster with pulses of %.0f us: %.4f to %.4f of programmed\n",
                  pulse_us,
                  figures.least,
                  figures.greatest);
      expect_even(figures);
    }
  }
}

}  // namespace
}  // namespace proof
