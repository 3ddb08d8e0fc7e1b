#include "host-sim/knowledge/regression.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "host-sim/knowledge/shipped_records.hpp"
#include "tests/support/random_source.hpp"
#include "tests/support/trials.hpp"

namespace sim {
namespace {

namespace kerf = cnc::kerf;

/// Returns a standard normal number, by the method of Box and Muller.
double normal(proof::Random& random) {
  const double radius = std::sqrt(-2.0 * std::log(1.0 - random.unit()));
  return radius * std::cos(6.283185307179586 * random.unit());
}

/// Returns Q in `unit`; each condition in the region of a thickness is equally likely.
double any_heat(const ThicknessRecord& row, kerf::HeatUnit unit, proof::Random& random) {
  const PowerRecord& power = row.powers[random.below(row.powers.size())];
  const auto speed = static_cast<std::uint32_t>(
      random.between(power.speeds_um_min.least, power.speeds_um_min.most));
  return kerf::heat_input<double>(unit, power.power_mw, speed);
}

MaterialRecord csp(kerf::HeatUnit unit) {
  for (const MaterialRecord& record : shipped_records()) {
    if (record.name == "CSP 1N" && record.unit == unit) return record;
  }
  return {};
}

struct Table3 {
  double slope, intercept, correlation;
};
constexpr Table3 kTable3[]{
    {0.0097, 0.398, 0.93}, {0.0085, 0.441, 0.94}, {0.0053, 0.546, 0.91}, {0.0061, 0.560, 0.90}};

constexpr double kNoiseMm = 0.01;
// Half a unit of the last digit that the paper prints.
constexpr double kSlopeDigit = 0.5e-4;
constexpr double kInterceptDigit = 0.5e-3;

/// The number of samples in J/mm makes four standard errors of both coefficients less than half a
/// printed digit. A correct fit then rounds to Table 3 in all but a few of 10,000 runs.
TEST(Regression, ReturnsTable3FromNoisySamplesInJoulesPerMillimetre) {
  constexpr std::size_t kSamples = 400'000;
  const MaterialRecord record = csp(kerf::HeatUnit::kJoulesPerMillimetre);
  ASSERT_EQ(record.thicknesses.size(), 4U);
  for (std::size_t i = 0; i < 4; ++i) {
    proof::Random random{7 + i};
    std::vector<Sample> samples;
    for (std::size_t n = 0; n < kSamples; ++n) {
      const double heat = any_heat(record.thicknesses[i], record.unit, random);
      samples.push_back(
          {heat, kTable3[i].slope * heat + kTable3[i].intercept + kNoiseMm * normal(random)});
    }
    const Regression line = fit_line(samples);
    const double slope_error = kNoiseMm / std::sqrt(line.squares_x);
    const double intercept_error =
        kNoiseMm * std::sqrt(1.0 / kSamples + line.mean_x * line.mean_x / line.squares_x);
    ASSERT_LT(4.0 * slope_error, kSlopeDigit) << "or the test would prove nothing";
    ASSERT_LT(4.0 * intercept_error, kInterceptDigit);
    EXPECT_NEAR(std::round(line.slope * 1e4) / 1e4, kTable3[i].slope, 1e-9);
    EXPECT_NEAR(std::round(line.intercept * 1e3) / 1e3, kTable3[i].intercept, 1e-9);
    EXPECT_NEAR(line.residual_sd, kNoiseMm, 0.0001);
    // Value of r that follows from slope, spread and noise.
    const double signal = line.slope * std::sqrt(line.squares_x / kSamples);
    const double expected = signal / std::hypot(signal, kNoiseMm);
    EXPECT_NEAR(line.correlation, expected, 0.001);
    std::printf("row %zu: r %.4f with 0.01 mm, %.2f printed\n",
                i,
                line.correlation,
                kTable3[i].correlation);
  }
}

/// With Q as printed, all widths of a thickness are within 2 µm. The same noise then leaves no
/// correlation, and no practical number of cuts reproduces the digits. Without noise, the fit
/// reproduces them.
TEST(Regression, ShowsThatThePrintedUnitCannotHaveBeenFitted) {
  const MaterialRecord record = csp(kerf::HeatUnit::kWattMinutesPerMillimetre);
  for (std::size_t i = 0; i < 4; ++i) {
    proof::Random random{70 + i};
    std::vector<Sample> noisy;
    std::vector<Sample> exact;
    for (int n = 0; n < 100'000; ++n) {
      const double heat = any_heat(record.thicknesses[i], record.unit, random);
      const double width = kTable3[i].slope * heat + kTable3[i].intercept;
      exact.push_back({heat, width});
      noisy.push_back({heat, width + kNoiseMm * normal(random)});
    }
    EXPECT_LT(std::abs(fit_line(noisy).correlation), 0.1);
    EXPECT_NEAR(fit_line(exact).slope, kTable3[i].slope, 1e-9);
    EXPECT_NEAR(fit_line(exact).intercept, kTable3[i].intercept, 1e-9);
    EXPECT_NEAR(fit_line(exact).correlation, 1.0, 1e-9);
  }
}

/// From the residual that a shipped record derives from the printed r, the same r must result.
TEST(Regression, GivesThePrintedCorrelationForTheResidualThatItImplies) {
  const MaterialRecord record = csp(kerf::HeatUnit::kJoulesPerMillimetre);
  for (std::size_t i = 0; i < 4; ++i) {
    const ThicknessRecord& row = record.thicknesses[i];
    proof::Random random{700 + i};
    std::vector<Sample> samples;
    double cuts = 0.0;
    for (const PowerRecord& power : row.powers) {
      cuts += 1.0 + (power.speeds_um_min.most - power.speeds_um_min.least) / 1'000'000;
    }
    // With so few cuts, the line uses two degrees of freedom.
    const double scatter = row.residual_sd_mm * std::sqrt((cuts - 2.0) / cuts);
    for (int repeat = 0; repeat < 5000; ++repeat) {
      for (const PowerRecord& power : row.powers) {
        for (std::uint32_t v = power.speeds_um_min.least; v <= power.speeds_um_min.most;
             v += 1'000'000) {
          const auto heat = kerf::heat_input<double>(record.unit, power.power_mw, v);
          samples.push_back({heat, row.slope * heat + scatter * normal(random)});
        }
      }
    }
    EXPECT_NEAR(fit_line(samples).correlation, kTable3[i].correlation, 0.002);
  }
}

TEST(Regression, KnowsStudentsT) {
  // Abramowitz and Stegun, table 26.10, A = 0.95.
  const std::vector<std::pair<std::size_t, double>> printed{{1, 12.706},
                                                            {2, 4.303},
                                                            {3, 3.182},
                                                            {4, 2.776},
                                                            {5, 2.571},
                                                            {10, 2.228},
                                                            {30, 2.042},
                                                            {60, 2.000},
                                                            {120, 1.980},
                                                            {0, 1.960}};
  for (const auto& [degrees, t] : printed) EXPECT_NEAR(student_t95(degrees), t, 5.1e-4) << degrees;
  // From here on a series is used, where t decreases by 6e-5.
  EXPECT_NEAR(student_t95(201), student_t95(200) - 6e-5, 2e-5);
}

}  // namespace
}  // namespace sim
