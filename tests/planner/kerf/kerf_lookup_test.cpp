#include "planner/kerf/kerf_lookup.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "planner/kerf/csp_1n.hpp"
#include "tests/planner/kerf/random_table.hpp"
#include "tests/support/trials.hpp"

namespace cnc::kerf {
namespace {

/// Table 2, typed from the paper independently of the product: mm, W, mm/min.
struct Printed {
  double thickness, power, least, most;
};
const std::vector<Printed> kTable2{{0.5, 1200, 4000, 10000},
                                   {0.5, 1400, 4000, 10000},
                                   {0.5, 1600, 5000, 9000},
                                   {0.5, 1800, 5000, 9000},
                                   {1.0, 1200, 4000, 6000},
                                   {1.0, 1400, 4000, 7000},
                                   {1.0, 1600, 4000, 7000},
                                   {1.0, 1800, 4000, 7000},
                                   {1.6, 1200, 2000, 5000},
                                   {1.6, 1400, 2000, 5000},
                                   {1.6, 1600, 3000, 5000},
                                   {1.6, 1800, 3000, 5000},
                                   {2.0, 1200, 3000, 4000},
                                   {2.0, 1400, 3000, 5000},
                                   {2.0, 1600, 3000, 5000},
                                   {2.0, 1800, 3000, 5000}};
/// Table 3: T, λ1, λ2.
const std::vector<std::vector<double>> kTable3{
    {0.5, 0.0097, 0.398}, {1.0, 0.0085, 0.441}, {1.6, 0.0053, 0.546}, {2.0, 0.0061, 0.560}};

Condition at(double thickness, double power, double speed) {
  const auto thousandths = [](double x) {
    return static_cast<std::uint32_t>(std::lround(x * 1e3));
  };
  return {thousandths(thickness), thousandths(power), thousandths(speed)};
}

double kerf_of(const Condition& condition) { return kerf_width(kCsp1n<double>, condition).value(); }

Refusal refusal_of(const Condition& condition) {
  return kerf_width(kCsp1n<double>, condition).error();
}

TEST(KerfLookup, GivesTheWorkedExampleAsPrinted) {
  constexpr Condition kWorked{2000, 1'800'000, 4'000'000};
  static_assert(kerf_width(kCsp1n<double>, kWorked).value() > 0.5627449999);
  static_assert(kerf_width(kCsp1n<double>, kWorked).value() < 0.5627450001);
  EXPECT_NEAR(static_cast<double>(kerf_width(kCsp1n<float>, kWorked).value()), 0.562745, 1.0e-7);
  EXPECT_NEAR(kerf_width(kCsp1nPhysical<double>, kWorked).value(), 0.7247, 5.0e-5);
}

TEST(KerfLookup, FollowsTable3InEveryRowOfTable2) {
  for (const Printed& row : kTable2) {
    for (const auto& law : kTable3) {
      if (law[0] != row.thickness) continue;
      for (const double speed : {row.least, 0.5 * (row.least + row.most), row.most}) {
        EXPECT_NEAR(kerf_of(at(row.thickness, row.power, speed)),
                    law[1] * row.power / speed + law[2],
                    1.0e-12);
      }
    }
  }
}

TEST(KerfLookup, RefusesEverySpeedOutsideTable2AndSaysWhatIsPermissible) {
  for (const Printed& row : kTable2) {
    for (const double speed : {row.least - 0.001, row.most + 0.001, 1.0, 20'000.0, 0.0}) {
      const auto refused = kerf_width(kCsp1n<double>, at(row.thickness, row.power, speed));
      ASSERT_FALSE(refused.ok()) << row.thickness << ' ' << row.power << ' ' << speed;
      EXPECT_EQ(refused.error().reason, RefusalReason::kSpeed);
      EXPECT_EQ(refused.error().least, static_cast<std::uint32_t>(row.least * 1000));
      EXPECT_EQ(refused.error().most, static_cast<std::uint32_t>(row.most * 1000));
    }
  }
}

TEST(KerfLookup, RefusesThicknessAndPowerOutsideTheTable) {
  for (const double thickness : {0.0, 0.499, 2.001, 90.0}) {
    EXPECT_EQ(refusal_of(at(thickness, 1400, 4000)).reason, RefusalReason::kThickness);
    EXPECT_EQ(refusal_of(at(thickness, 1400, 4000)).least, 500U);
    EXPECT_EQ(refusal_of(at(thickness, 1400, 4000)).most, 2000U);
  }
  for (const double power : {0.0, 1199.999, 1800.001, 5000.0}) {
    EXPECT_EQ(refusal_of(at(1.0, power, 5000)).reason, RefusalReason::kPower);
    EXPECT_EQ(refusal_of(at(1.0, power, 5000)).least, 1'200'000U);
  }
}

TEST(KerfLookup, TakesWhatAllRowsAroundPermit) {
  // Between 1.0 and 1.6 mm at 1200 W, the ranges are 4000…6000 and 2000…5000.
  const auto window = permissible_speeds(kCsp1n<double>, 1300, 1'200'000).value();
  EXPECT_EQ(window.least, 4'000'000U);
  EXPECT_EQ(window.most, 5'000'000U);
  // Between 1200 and 1400 W at 2.0 mm, the ranges are 3000…4000 and 3000…5000.
  EXPECT_EQ(permissible_speeds(kCsp1n<double>, 2000, 1'300'000).value().most, 4'000'000U);
  // Between two thicknesses and two powers.
  const auto all = permissible_speeds(kCsp1n<double>, 1800, 1'500'000).value();
  EXPECT_EQ(all.least, 3'000'000U);
  EXPECT_EQ(all.most, 5'000'000U);
}

TEST(KerfLookup, IsStraightBetweenThicknesses) {
  const double thin = kerf_of(at(1.0, 1400, 4500));
  const double thick = kerf_of(at(1.6, 1400, 4500));
  EXPECT_NEAR(kerf_of(at(1.15, 1400, 4500)), 0.75 * thin + 0.25 * thick, 1.0e-12);
}

TEST(KerfLookup, SaysWhereNoSpeedIsInCommon) {
  OwnedTable<double> table;
  table.rows = {{1000, {0.0, 0.3}, false, 0, 2}, {2000, {0.0, 0.4}, false, 2, 1}};
  table.bands = {{100, 5000, 9000, 0, 0}, {300, 2000, 4000, 0, 0}, {200, 1000, 3000, 0, 0}};
  ASSERT_FALSE(find_fault(table.view()));
  EXPECT_EQ(kerf_width(table.view(), {1000, 200, 5000}).error().reason, RefusalReason::kNoSpeed);
  EXPECT_EQ(kerf_width(table.view(), {1500, 200, 3000}).error().reason, RefusalReason::kNoSpeed);
  EXPECT_EQ(kerf_width(table.view(), {1500, 250, 3000}).error().reason, RefusalReason::kPower);
  table.bands[2].power_mw = 400;
  EXPECT_EQ(kerf_width(table.view(), {1500, 300, 3000}).error().reason, RefusalReason::kNoSpeed);
}

TEST(KerfLookup, JoinsMeasuredPointsByLines) {
  OwnedTable<double> table;
  table.rows = {{3000, {}, true, 0, 2}};
  table.bands = {{40'000, 600'000, 1'000'000, 0, 3}, {60'000, 700'000, 900'000, 3, 2}};
  table.points = {{600'000, 300'000},
                  {800'000, 280'000},
                  {1'000'000, 200'000},
                  {700'000, 350'000},
                  {900'000, 330'000}};
  ASSERT_FALSE(find_fault(table.view()));
  const auto kerf = [&table](std::uint32_t power, std::uint32_t speed) {
    return kerf_width(table.view(), {3000, power, speed}).value();
  };
  EXPECT_NEAR(kerf(40'000, 700'000), 0.29, 1e-12);
  EXPECT_NEAR(kerf(40'000, 900'000), 0.24, 1e-12);
  EXPECT_NEAR(kerf(50'000, 900'000), 0.5 * (0.24 + 0.33), 1e-12);
  EXPECT_FALSE(kerf_width(table.view(), {3000, 50'000, 950'000}).ok());
}

/// Returns the rows around a value, by another method than the product's.
template <typename List, typename Key>
std::pair<std::size_t, std::size_t> around(const List& list, Key key, std::uint32_t value) {
  std::pair<std::size_t, std::size_t> found{0, 0};
  for (std::size_t i = 0; i < list.size(); ++i) {
    if (list[i].*key <= value) found.first = i;
  }
  for (std::size_t i = list.size(); i-- > 0;) {
    if (list[i].*key >= value) found.second = i;
  }
  return found;
}

/// For any sound table and any condition, single precision refuses the same cases and is within 1
/// µm.
TEST(KerfLookup, IsOnTheControllerWithinAMicrometreOfTheHost) {
  const proof::Trials trials{4000};
  double greatest = 0.0;
  std::size_t cut = 0;
  std::size_t refused = 0;
  for (const std::uint64_t seed : trials) {
    SCOPED_TRACE("KERFLINE_SEED=" + std::to_string(seed));
    proof::Random random{seed};
    RandomTable tables{random};
    const OwnedTable<double> table = tables.next();
    const OwnedTable<float> single = in_single(table);
    ASSERT_FALSE(find_fault(table.view()));
    ASSERT_FALSE(find_fault(single.view()));
    for (int i = 0; i < 100; ++i) {
      const Row<double>& row = table.rows[random.below(table.rows.size())];
      const auto bands = table.view().bands_of(row);
      const Band& band = bands[random.below(bands.size())];
      Condition condition{row.thickness_um, band.power_mw, band.min_um_min};
      if (random.chance(0.5)) {
        condition.thickness_um = tables.rising(1, 1, kMaxThicknessUm).front();
      }
      if (random.chance(0.5)) condition.power_mw = tables.rising(1, 100, kMaxPowerMw).front();
      condition.speed_um_min = tables.rising(1, band.min_um_min, band.max_um_min).front();
      const auto exact = kerf_width(table.view(), condition);
      const auto rounded = kerf_width(single.view(), condition);
      ASSERT_EQ(exact.ok(), rounded.ok());
      if (!exact.ok()) {
        ++refused;
        EXPECT_EQ(exact.error().least, rounded.error().least);
        EXPECT_EQ(exact.error().most, rounded.error().most);
        continue;
      }
      ++cut;
      greatest = std::max(greatest, std::abs(exact.value() - static_cast<double>(rounded.value())));
      const auto rows = around(table.rows, &Row<double>::thickness_um, condition.thickness_um);
      for (const std::size_t i_row : {rows.first, rows.second}) {
        const auto near = table.view().bands_of(table.rows[i_row]);
        const std::vector<Band> list{near.begin(), near.end()};
        const auto found = around(list, &Band::power_mw, condition.power_mw);
        for (const std::size_t i_band : {found.first, found.second}) {
          EXPECT_GE(condition.speed_um_min, list[i_band].min_um_min);
          EXPECT_LE(condition.speed_um_min, list[i_band].max_um_min);
        }
      }
      ASSERT_LE(greatest, 1.0e-3);
    }
  }
  std::printf(
      "%zu widths, %zu refusals, greatest difference %.6f um\n", cut, refused, greatest * 1000.0);
  if (trials.judges_shares()) {
    EXPECT_GT(cut, 10 * trials.count());
  }
  if (trials.judges_shares()) {
    EXPECT_GT(refused, trials.count());
  }
}

}  // namespace
}  // namespace cnc::kerf
