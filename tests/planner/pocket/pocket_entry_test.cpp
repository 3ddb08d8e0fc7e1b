#include "planner/pocket/pocket_entry.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "planner/pocket/loop_driver.hpp"
#include "tests/planner/pocket/path_bench.hpp"
#include "tests/support/trials.hpp"

namespace cnc::pocket {
namespace {

/// Entries into an area that is its own locus, with their storage.
class EntryBench {
 public:
  explicit EntryBench(const contour::ContourView<double>& area) : area_{area} {
    EXPECT_TRUE(boundary_.read(area));
    plain_.add(area);
  }
  EntryPlan<double> plan(std::size_t loop, Milling milling, const EntryOptions<double>& options) {
    return plan_entry<double>(area_, boundary_, area_, loop, milling, options);
  }
  EntryResult write(const EntryPlan<double>& plan,
                    Milling milling,
                    const EntryOptions<double>& options,
                    double z_from,
                    double z_to) {
    writer_.clear();
    const EntryResult result =
        write_entry<double>(plan, area_, milling, options, {z_from, z_to}, writer_);
    const WideVec2 end = plan.place.pose.point;
    if (result == EntryResult::kDone) {
      EXPECT_TRUE(writer_.add({end.x(), end.y(), z_to}));
      EXPECT_TRUE(writer_.end_row());
    }
    return result;
  }
  [[nodiscard]] ToolPathView<double> path() const { return writer_.view(); }
  [[nodiscard]] const PlainContour& plain() const { return plain_; }

  /// Returns the distance by which the path leaves the area; 0 if it stays inside.
  [[nodiscard]] double outside() const {
    double worst = 0.0;
    for_each_element(path(), [&](const auto& from, const auto& to) {
      if (from.point() == to.point()) return;
      const contour::exact::PlainArc arc{arc_of(from, to)};
      for (int i = 0; i < 24; ++i) {
        const WideVec2 place = arc.at((i + 0.5) / 24.0);
        const double away = plain_.distance(place);
        if (away > 1.0e-8 && !plain_.encloses(place)) worst = std::max(worst, away);
      }
    });
    return worst;
  }
  [[nodiscard]] double steepest() const {
    double worst = 0.0;
    for_each_element(path(), [&](const auto& from, const auto& to) {
      const double drop = from.z - to.z;
      EXPECT_GE(drop, -1.0e-12);
      if (drop > 1.0e-9) worst = std::max(worst, drop / flat_length(from, to));
    });
    return worst;
  }

 private:
  contour::ContourView<double> area_;
  std::vector<contour::Curve<double>> curves_{PocketBench::kElements};
  std::vector<contour::FlatBox<double>> boxes_ = std::vector<contour::FlatBox<double>>(
      contour::BoxTree<double>::size_for(PocketBench::kElements));
  NearestCurve<double> boundary_{{curves_.data(), curves_.size()}, {boxes_.data(), boxes_.size()}};
  PlainContour plain_;
  std::vector<PathPoint<double>> points_{100'000};
  std::array<std::uint32_t, 4> row_ends_{};
  ToolPathWriter<double> writer_{{points_.data(), points_.size()}, row_ends_};
};

constexpr EntryOptions<double> kHelix{EntryKind::kHelix, 0.05, 4.0};

TEST(PocketEntry, AHelixTouchesTheLoopFromWithin) {
  PocketBench pocket;
  pocket.rectangle(0, 0, 30, 20);
  EntryBench bench{pocket.pocket()};
  const auto plan = bench.plan(0, Milling::kClimb, kHelix);
  EXPECT_EQ(plan.kind, EntryKind::kHelix);
  EXPECT_EQ(plan.helix_radius, 4.0);
  EXPECT_EQ(plan.place.pose.point, (WideVec2{15, 0}));
  ASSERT_EQ(bench.write(plan, Milling::kClimb, kHelix, -1.0, -4.0), EntryResult::kDone);
  EXPECT_EQ(bench.outside(), 0.0);
  EXPECT_LE(bench.steepest(), 0.05 + 1.0e-9);
  // 3 mm at 5 % of 25 mm are 2.4 revolutions, which gives three, of two halves each.
  EXPECT_EQ(bench.path().points.size(), 7U);
  EXPECT_EQ(bench.path().points[0].z, -1.0);
  EXPECT_EQ(bench.path().points[0].bulge, 1.0);
}

TEST(PocketEntry, AgainstTheLoopTheHelixTurnsRight) {
  PocketBench pocket;
  pocket.rectangle(0, 0, 30, 20);
  EntryBench bench{pocket.pocket()};
  const auto plan = bench.plan(0, Milling::kConventional, kHelix);
  ASSERT_EQ(bench.write(plan, Milling::kConventional, kHelix, 0.0, -1.0), EntryResult::kDone);
  EXPECT_EQ(bench.path().points[0].bulge, -1.0);
  EXPECT_EQ(bench.outside(), 0.0);
}

TEST(PocketEntry, TheHelixShrinksToFitAndBecomesARampWhereNoneFits) {
  PocketBench narrow;
  narrow.rectangle(0, 0, 30, 5);
  EntryBench half{narrow.pocket()};
  EXPECT_EQ(half.plan(0, Milling::kClimb, kHelix).helix_radius, 2.0);
  PocketBench slot;
  slot.rectangle(0, 0, 30, 0.5);
  EntryBench none{slot.pocket()};
  const auto plan = none.plan(0, Milling::kClimb, kHelix);
  EXPECT_EQ(plan.kind, EntryKind::kRamp);
  ASSERT_EQ(none.write(plan, Milling::kClimb, kHelix, 0.0, -4.0), EntryResult::kDone);
  EXPECT_LE(none.steepest(), 0.05 + 1.0e-9);
  EXPECT_EQ(none.outside(), 0.0);
}

TEST(PocketEntry, ALoopTooShortForARampIsReported) {
  PocketBench dot;
  dot.rectangle(0, 0, 0.01, 0.01);
  EntryBench bench{dot.pocket()};
  const auto plan = bench.plan(0, Milling::kClimb, kHelix);
  EXPECT_EQ(bench.write(plan, Milling::kClimb, kHelix, 0.0, -4.0), EntryResult::kTooShort);
}

TEST(PocketEntry, APlungeGoesStraightDown) {
  PocketBench pocket;
  pocket.rectangle(0, 0, 30, 20);
  EntryBench bench{pocket.pocket()};
  const EntryOptions<double> plunge{EntryKind::kPlunge};
  const auto plan = bench.plan(0, Milling::kClimb, plunge);
  ASSERT_EQ(bench.write(plan, Milling::kClimb, plunge, 0.0, -4.0), EntryResult::kDone);
  ASSERT_EQ(bench.path().points.size(), 2U);
  EXPECT_EQ(bench.path().points[0].point(), bench.path().points[1].point());
}

TEST(LoopDriver, GoesAroundOnceEitherWay) {
  PocketBench pocket;
  pocket.add(0, 0).add(10, 0, 0.5).add(10, 10).add(0, 10, -0.25).close();
  const auto area = pocket.pocket();
  std::array<PathPoint<double>, 16> points{};
  std::array<std::uint32_t, 2> row_ends{};
  for (const Milling milling : {Milling::kClimb, Milling::kConventional}) {
    ToolPathWriter<double> writer{points, row_ends};
    const LoopPlace<double> place{0, 0, {{4, 0}, {1, 0}}};
    ASSERT_TRUE(drive_loop<double>(area, place, milling, {0.0, -1.0, Use::kPass}, writer));
    ASSERT_TRUE(writer.add({4, 0, -1}));
    ASSERT_TRUE(writer.end_row());
    ASSERT_EQ(writer.view().points.size(), 6U);
    double length = 0.0;
    for_each_element(writer.view(), [&](const auto& from, const auto& to) {
      const double flat = flat_length(from, to);
      EXPECT_NEAR(from.z - to.z, flat / loop_length(area, 0), 1.0e-12);
      length += flat;
    });
    EXPECT_NEAR(length, loop_length(area, 0), 1.0e-12);
    EXPECT_EQ(points[1].x, milling == Milling::kClimb ? 10.0 : 0.0);
    EXPECT_EQ(points[1].bulge, milling == Milling::kClimb ? 0.5 : 0.25);
  }
}

TEST(PocketEntry, InRandomAreasStaysInsideAndIsNotTooSteep) {
  for (const std::uint64_t seed : proof::Trials{200}) {
    proof::Random random{seed};
    PocketBench pocket;
    const double radius = add_random_pocket(pocket, random);
    EntryBench bench{pocket.pocket()};
    const EntryOptions<double> options{random.chance(0.7) ? EntryKind::kHelix : EntryKind::kRamp,
                                       random.magnitude(0.02, 1.0),
                                       random.between(0.2, 1.0) * radius};
    const Milling milling = random.chance(0.5) ? Milling::kClimb : Milling::kConventional;
    const auto plan = bench.plan(random.below(pocket.pocket().loop_ends.size()), milling, options);
    const double depth = random.magnitude(0.1, 2.0) * radius;
    const EntryResult result = bench.write(plan, milling, options, 0.0, -depth);
    ASSERT_EQ(result, EntryResult::kDone) << "KERFLINE_SEED=" << seed;
    EXPECT_LT(bench.outside(), 1.0e-8) << "KERFLINE_SEED=" << seed;
    EXPECT_LE(bench.steepest(), options.slope * (1.0 + 1.0e-9)) << "KERFLINE_SEED=" << seed;
  }
}

}  // namespace
}  // namespace cnc::pocket
