#include "host-sim/knowledge/fit.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <vector>

#include "host-sim/knowledge/flash_lines.hpp"
#include "host-sim/knowledge/shipped_records.hpp"
#include "planner/kerf/table_check.hpp"
#include "planner/kerf/table_image.hpp"
#include "tests/support/random_source.hpp"
#include "tests/support/trials.hpp"

namespace sim {
namespace {

namespace kerf = cnc::kerf;

Experiment cut_at(double thickness, double power, double speed, double width) {
  return {.material = "test",
          .laser = "laser",
          .gas_pressure_mpa = 0.1,
          .condition = {to_thousandths(thickness), to_thousandths(power), to_thousandths(speed)},
          .kerf_top_mm = width + 0.02,
          .kerf_bottom_mm = width - 0.02};
}

const FitOptions kJoules{.unit = kerf::HeatUnit::kJoulesPerMillimetre};

std::vector<Experiment> cuts_of(const std::vector<double>& speeds,
                                const std::function<double(double, double)>& width) {
  std::vector<Experiment> cuts;
  for (const double power : {1000.0, 1500.0}) {
    for (const double speed : speeds) {
      cuts.push_back(cut_at(1.0, power, speed, width(power, speed)));
    }
  }
  return cuts;
}

double lawful(double power, double speed) { return 0.4 + 0.01 * 60.0 * power / speed; }

TEST(KerfFit, FindsTheLawOfTheMeanOfTopAndBottom) {
  const MaterialRecord record = fit_record(cuts_of({3000, 4000, 5000}, lawful), kJoules);
  ASSERT_EQ(record.thicknesses.size(), 1U);
  const ThicknessRecord& row = record.thicknesses[0];
  EXPECT_FALSE(row.measured);
  EXPECT_NEAR(row.slope, 0.01, 1e-12);
  EXPECT_NEAR(row.intercept, 0.4, 1e-12);
  EXPECT_NEAR(row.correlation, 1.0, 1e-12);
  EXPECT_EQ(row.samples, 6U);
  ASSERT_EQ(row.powers.size(), 2U);
  EXPECT_EQ(row.powers[1].speeds_um_min.least, 3'000'000U);
  EXPECT_EQ(row.powers[1].speeds_um_min.most, 5'000'000U);
}

TEST(KerfFit, PermitsTheLongestRunWithoutARejectedCut) {
  auto cuts = cuts_of({1000, 2000, 3000, 4000, 5000, 6000}, lawful);
  cuts[1].rejection = "dross";                    // A speed of 2000 at 1000 W.
  cuts.push_back(cut_at(1.0, 1000, 6000, 0.45));  // One of two cuts at 6000 is rejected.
  cuts.back().rejection = "dross";
  const MaterialRecord record = fit_record(cuts, kJoules);
  EXPECT_EQ(record.thicknesses[0].powers[0].speeds_um_min.least, 3'000'000U);
  EXPECT_EQ(record.thicknesses[0].powers[0].speeds_um_min.most, 5'000'000U);
  EXPECT_EQ(record.thicknesses[0].powers[1].speeds_um_min.least, 1'000'000U);
  EXPECT_EQ(record.thicknesses[0].samples, 3U + 6U) << "others are not fitted to";
}

/// Returns a width that jumps with the power: it is not a function of Q.
double lawless(double power, double) { return power > 1200.0 ? 0.7 : 0.4; }

TEST(KerfFit, KeepsTheWidthsWhereTheLawDoesNotHold) {
  const MaterialRecord record = fit_record(cuts_of({3000, 4000, 5000}, lawless), kJoules);
  const ThicknessRecord& row = record.thicknesses[0];
  EXPECT_TRUE(row.measured);
  EXPECT_GT(row.greatest_residual_mm, 0.05);
  const auto narrow = predict(record, {1000, 1'000'000, 3'500'000});
  const auto middle = predict(record, {1000, 1'250'000, 3'500'000});
  EXPECT_NEAR(narrow.value().kerf_mm, 0.4, 1e-9);
  EXPECT_NEAR(middle.value().kerf_mm, 0.55, 1e-9);
}

TEST(KerfFit, HoldsItsCriterionOnBothSides) {
  // One mean is raised by a bump. Its residual is about 0.56 of the bump, as the line bends towards
  // it.
  const auto with_bump = [](double bump) {
    return fit_record(cuts_of({3000, 4000, 5000},
                              [bump](double power, double speed) {
                                const bool here = power == 1000.0 && speed == 4000.0;
                                return 0.4 + (here ? bump : 0.0);
                              }),
                      kJoules)
        .thicknesses[0];
  };
  for (double bump = 0.0; bump < 0.06; bump += 0.002) {
    const ThicknessRecord row = with_bump(bump);
    EXPECT_EQ(row.measured, row.greatest_residual_mm > 0.02) << "r " << row.correlation;
  }
  EXPECT_FALSE(with_bump(0.01).measured);
  EXPECT_TRUE(with_bump(0.058).measured);
}

TEST(KerfFit, NeedsThreeHeatInputsForALaw) {
  EXPECT_TRUE(fit_record(cuts_of({3000}, lawful), kJoules).thicknesses[0].measured);
  EXPECT_FALSE(fit_record(cuts_of({3000, 4000}, lawful), kJoules).thicknesses[0].measured);
}

TEST(KerfFit, RefusesWhatDoesNotBelongTogether) {
  auto cuts = cuts_of({3000, 4000}, lawful);
  cuts[1].laser = "another";
  EXPECT_THROW(static_cast<void>(fit_record(cuts, kJoules)), std::invalid_argument);
  cuts = cuts_of({3000, 4000}, lawful);
  cuts[1].gas_pressure_mpa = 0.2;
  EXPECT_THROW(static_cast<void>(fit_record(cuts, kJoules)), std::invalid_argument);
  cuts = cuts_of({3000, 4000}, lawful);
  for (Experiment& cut : cuts) cut.rejection = "dross";
  EXPECT_THROW(static_cast<void>(fit_record(cuts, kJoules)), std::invalid_argument);
}

/// 95 % of new cuts with the same scatter must be within the interval, for few and for many
/// samples.
TEST(KerfFit, ItsIntervalHoldsNinetyFiveOfAHundredCuts) {
  const proof::Trials trials{3000};
  // The scatter is greater than the measuring error, which is a lower bound.
  constexpr double kScatterMm = 0.03;
  std::size_t within = 0;
  for (const std::uint64_t seed : trials) {
    proof::Random random{seed};
    const auto normal = [&random] {
      double sum = -6.0;
      for (int i = 0; i < 12; ++i) sum += random.unit();
      return sum;
    };
    const auto scattered = [&](double power, double speed) {
      return lawful(power, speed) + kScatterMm * normal();
    };
    FitOptions options = kJoules;
    options.criterion.close_mm = 1.0;
    const MaterialRecord record = fit_record(cuts_of({3000, 4000, 5000}, scattered), options);
    const double speed = random.between(3000, 5000);
    const auto found = predict(record, {1000, 1'500'000, to_thousandths(speed)});
    const double off = scattered(1500, speed) - found.value().kerf_mm;
    if (std::abs(off) <= found.value().half_interval_mm) ++within;
  }
  const double share = static_cast<double>(within) / static_cast<double>(trials.count());
  std::printf("%.3f of new cuts within the interval\n", share);
  EXPECT_NEAR(share, 0.95, 4.0 * std::sqrt(0.95 * 0.05 / static_cast<double>(trials.count())));
}

TEST(ShippedRecords, AreSoundAndSayWhatTheyAreWorth) {
  for (const MaterialRecord& record : shipped_records()) {
    EXPECT_NO_THROW(require_sound(record));
    EXPECT_FALSE(record.calibrated);
    EXPECT_FALSE(flash_image(record, record.name).empty());
  }
  EXPECT_NE(shipped_records().back().provenance.find("uncalibrated"), std::string::npos);
}

TEST(ShippedRecords, KeepWithinTheRangesOfTable1) {
  const MaterialRecord record = shipped_records().front();
  EXPECT_EQ(record.thicknesses.front().thickness_um, to_thousandths(kCsp1nRange.min_thickness_mm));
  EXPECT_EQ(record.thicknesses.back().thickness_um, to_thousandths(kCsp1nRange.max_thickness_mm));
  for (const ThicknessRecord& row : record.thicknesses) {
    for (const PowerRecord& power : row.powers) {
      EXPECT_GE(power.power_mw, to_thousandths(kCsp1nRange.min_power_w));
      EXPECT_LE(power.power_mw, to_thousandths(kCsp1nRange.max_power_w));
      EXPECT_GE(power.speeds_um_min.least, to_thousandths(kCsp1nRange.min_speed_mm_min));
      EXPECT_LE(power.speeds_um_min.most, to_thousandths(kCsp1nRange.max_speed_mm_min));
    }
  }
}

TEST(ShippedRecords, PredictTheWorkedExample) {
  const auto found = predict(shipped_records()[0], {2000, 1'800'000, 4'000'000});
  EXPECT_NEAR(found.value().kerf_mm, 0.562745, 1e-9);
  EXPECT_NEAR(found.value().heat, 0.45, 1e-12);
  EXPECT_EQ(found.value().half_interval_mm, kMeasuringErrorMm) << "its scatter is far below";
}

TEST(FlashImage, SaysWhatDoesNotFit) {
  MaterialRecord record = shipped_records().back();
  record.thicknesses.clear();
  for (std::uint32_t i = 0; i < 9; ++i) {
    record.thicknesses.push_back(
        {.thickness_um = 1000 + i, .intercept = 0.3, .powers = {{1000, {5000, 9000}, {}}}});
  }
  try {
    static_cast<void>(flash_image(record, "nine"));
    FAIL();
  } catch (const std::invalid_argument& error) {
    EXPECT_STREQ(error.what(), "nine: kerf table has 9 thicknesses, capacity 8");
  }
}

TEST(FlashImage, IsTheTableInSinglePrecision) {
  const MaterialRecord record = shipped_records()[1];
  kerf::StoredTable table;
  ASSERT_FALSE(kerf::read_image(flash_image(record, "steel"), table));
  EXPECT_EQ(table.view().name, "steel");
  const auto width = kerf::kerf_width(table.view(), {2000, 1'800'000, 4'000'000});
  EXPECT_NEAR(static_cast<double>(width.value()), 0.7247, 1e-6);
}

}  // namespace
}  // namespace sim
