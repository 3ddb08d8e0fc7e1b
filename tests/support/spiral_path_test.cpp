#include "host-sim/pocket/spiral_path.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <string>

#include "host-sim/contour/contour_text.hpp"
#include "tests/planner/pocket/path_bench.hpp"
#include "tests/support/trials.hpp"

namespace proof {
namespace {

using cnc::WideVec2;
using cnc::pocket::PathPoint;
using cnc::pocket::Use;
using sim::pocket::PocketPlan;
using sim::pocket::SpiralPath;

/// Options of a pocket that is cleared in spirals.
struct SpiralWish {
  double radius_mm = 3.0;
  double corner_mm = 0.3;
  double stepover_mm = 2.7;
  cnc::pocket::Milling milling = cnc::pocket::Milling::kClimb;

  [[nodiscard]] SpiralPath path_of(const sim::Contour& area) const {
    cnc::pocket::PocketOptions<double> options;
    options.clearing = {radius_mm, corner_mm, stepover_mm};
    options.entry = {cnc::pocket::EntryKind::kPlunge, 0.05, 0.9 * radius_mm};
    options.depth = options.depth_step = 0.1 * radius_mm;
    sim::pocket::PocketPlanner planner;
    const PocketPlan plan = planner.plan(area.view(), options);
    sim::pocket::SpiralOptions wanted{
        radius_mm, options.depth, options.entry, milling, stepover_mm};
    wanted.entry.kind = cnc::pocket::EntryKind::kHelix;
    return spiral_path(plan, wanted);
  }
};

/// Finds faults of a path by distances and samples that are computed independently of the planner.
class SpiralCheck {
 public:
  SpiralCheck(const sim::Contour& area, const SpiralPath& path, const SpiralWish& wish)
      : path_{path},
        wish_{wish},
        locus_{offset(area, -wish.radius_mm)},
        oracle_{area.view(), locus_.view(), wish.radius_mm} {
    locus_walls_.add(locus_.view());
    cnc::pocket::for_each_element(path.path(), [this](const auto& from, const auto& to) {
      if (from.use == Use::kPass && cnc::pocket::flat_length(from, to) > 0.0) {
        oracle_.add_pass_element(cnc::pocket::arc_of(from, to));
      }
    });
  }

  std::string run(Random& random) {
    for (std::size_t row = 0; row < path_.row_ends.size(); ++row) check_row(row);
    const double far = oracle_.farthest(random, 300) - wish_.radius_mm;
    if (far > 1.0e-6) complain("leaves " + std::to_string(far) + " mm", {0.0, 0.0});
    const double gouge = wish_.radius_mm - oracle_.min_clearance();
    if (gouge > 1.0e-6) complain("gouges by " + std::to_string(gouge), {0.0, 0.0});
    return complaint_;
  }
  [[nodiscard]] double length() const { return oracle_.length(); }

 private:
  static sim::Contour offset(const sim::Contour& area, double distance) {
    sim::ContourOffset offsetter;
    return sim::copy_of(offsetter.offset(area.view(), distance));
  }

  void complain(const std::string& text, const WideVec2& place) {
    if (!complaint_.empty()) return;
    complaint_ = text + " at " + std::to_string(place.x()) + " " + std::to_string(place.y());
  }

  void check_row(std::size_t row) {
    const std::uint32_t begin = path_.path().row_begin(row);
    const std::uint32_t end = path_.row_ends[row];
    for (std::uint32_t i = begin; i + 2 < end; ++i) {
      check_joint(path_.points[i], path_.points[i + 1], path_.points[i + 2]);
    }
  }

  /// Checks that the path has corners only at the wall and where a ramp begins or ends.
  void check_joint(const PathPoint<double>& a,
                   const PathPoint<double>& b,
                   const PathPoint<double>& c) {
    if (wish_.corner_mm == 0.0 || a.use == Use::kEntry || b.use == Use::kEntry) return;
    if (cnc::pocket::flat_length(a, b) < 1.0e-4 || cnc::pocket::flat_length(b, c) < 1.0e-4) return;
    const double kink = cnc::pocket::kink_between(a, b, c);
    if (kink < 0.05 || locus_walls_.distance(b.point()) < 1.0e-6) return;
    complain("a corner of " + std::to_string(kink) + " degrees", b.point());
  }

  const SpiralPath& path_;
  SpiralWish wish_;
  sim::Contour locus_;
  cnc::pocket::PocketOracle oracle_;
  cnc::pocket::PlainContour locus_walls_;
  std::string complaint_;
};

constexpr const char* kSpiralRoom = "0 0\n60 0\n60 40\n0 40\nclosed\n";

TEST(SpiralPaths, ClearARoomInOneRow) {
  const sim::Contour area = sim::contour_from_text(kSpiralRoom, "test");
  const SpiralWish wish;
  const SpiralPath path = wish.path_of(area);
  EXPECT_EQ(path.row_ends.size(), 1U);
  // The wall's pass is 17 mm from the middle: the innermost loop, turns of the spiral, the
  // outermost loop and the wall.
  EXPECT_GE(path.turns, 4U);
  EXPECT_EQ(path.loops, 3U);
  Random random{1};
  EXPECT_EQ((SpiralCheck{area, path, wish}.run(random)), "");
}

TEST(SpiralPaths, RunAgainstTheLoopsWhereAsked) {
  const sim::Contour area = sim::contour_from_text(kSpiralRoom, "test");
  const SpiralWish wish{.milling = cnc::pocket::Milling::kConventional};
  const SpiralPath path = wish.path_of(area);
  EXPECT_EQ(path.row_ends.size(), 1U);
  Random random{1};
  EXPECT_EQ((SpiralCheck{area, path, wish}.run(random)), "");
}

TEST(SpiralPaths, HaveOneSpiralAroundAnIsland) {
  for (const char* const text :
       {"60 0 1\n-60 0 1\nclosed\n10 0 -1\n-10 0 -1\nclosed\n",
        "0 0\n90 0\n90 90\n0 90\nclosed\n30 30\n30 60\n60 60\n60 30\nclosed\n",
        // The island is 8 mm off the centre, so that the passes in the middle are not concentric
        // rings.
        "60 0 1\n-60 0 1\nclosed\n18 0 -1\n-2 0 -1\nclosed\n"}) {
    for (const auto milling : {cnc::pocket::Milling::kClimb, cnc::pocket::Milling::kConventional}) {
      const sim::Contour area = sim::contour_from_text(text, "test");
      const SpiralWish wish{.milling = milling};
      const SpiralPath path = wish.path_of(area);
      EXPECT_GE(path.turns, 4U);
      // The first and the last loop of the spiral, and both walls. The island's wall has its own
      // row unless a link leads there.
      EXPECT_EQ(path.loops, 4U) << text;
      EXPECT_LE(path.row_ends.size(), 2U) << text;
      Random random{1};
      EXPECT_EQ((SpiralCheck{area, path, wish}.run(random)), "") << text;
    }
  }
}

TEST(SpiralPaths, HaveTwoSpiralsAroundAnIslandNearAWall) {
  const sim::Contour area =
      sim::contour_from_text("60 0 1\n-60 0 1\nclosed\n45 0 -1\n25 0 -1\nclosed\n", "test");
  const SpiralWish wish;
  const SpiralPath path = wish.path_of(area);
  EXPECT_GE(path.turns, 4U);
  EXPECT_GT(path.loops, 4U);
  Random random{1};
  EXPECT_EQ((SpiralCheck{area, path, wish}.run(random)), "");
}

/// Appends a loop of lines and arcs around `centre`, from where all of the loop is visible.
void add_star(
    std::string& text, const WideVec2& centre, double radius_mm, bool is_island, Random& random) {
  const std::size_t corners = 3 + random.below(6);
  const double turn = random.between(0.0, 6.0);
  for (std::size_t i = 0; i < corners; ++i) {
    const double share =
        (static_cast<double>(i) + random.between(0.0, 0.4)) / static_cast<double>(corners);
    const double angle = turn + (is_island ? -1.0 : 1.0) * 2.0 * std::numbers::pi * share;
    const double away_mm = radius_mm * random.between(0.7, 1.0);
    const double bulge = random.chance(0.5) ? 0.0 : random.between(-0.2, 0.2);
    text += std::to_string(centre.x() + away_mm * std::cos(angle)) + " " +
            std::to_string(centre.y() + away_mm * std::sin(angle)) + " " + std::to_string(bulge) +
            "\n";
  }
  text += "closed\n";
}

TEST(SpiralPaths, ClearRandomRings) {
  std::size_t single = 0;
  std::size_t turns = 0;
  std::size_t refused = 0;
  for (const std::uint64_t seed : Trials{20}) {
    Random random{seed};
    SpiralWish wish;
    wish.radius_mm = random.between(1.0, 4.0);
    wish.corner_mm = random.between(0.02, 0.3) * wish.radius_mm;
    wish.stepover_mm =
        random.between(0.3, 1.0) * sim::pocket::widest_spiral_mm(wish.radius_mm, wish.corner_mm);
    if (random.chance(0.3)) wish.milling = cnc::pocket::Milling::kConventional;
    std::string text;
    add_star(text, {0.0, 0.0}, 60.0, false, random);
    const WideVec2 aside{random.between(-4.0, 4.0), random.between(-4.0, 4.0)};
    add_star(text, aside, random.between(2.0, 16.0), true, random);
    const sim::Contour area = sim::contour_from_text(text, "test");
    try {
      const SpiralPath path = wish.path_of(area);
      EXPECT_EQ((SpiralCheck{area, path, wish}.run(random)), "") << "KERFLINE_SEED=" << seed;
      if (path.loops == 4) ++single;
      turns += path.turns;
    } catch (const sim::pocket::NoPocketPath&) {
      ++refused;  // Contours cross, or a pass is too short for a ramp.
    }
  }
  std::printf("%zu turns, %zu with one spiral, %zu refused\n", turns, single, refused);
}

TEST(SpiralPaths, AreLoopsWhereTheCornersAreTooSharp) {
  // Two triangles. In the sharpest corner of the first one, loops are 6.7 R apart; in that of the
  // second one 2.6 R.
  for (const char* const text : {"0 0\n90 0\n0 25\nclosed\n", "0 0\n90 0\n0 75\nclosed\n"}) {
    const sim::Contour area = sim::contour_from_text(text, "test");
    const SpiralWish wish;
    const SpiralPath path = wish.path_of(area);
    EXPECT_EQ(path.turns, 0U);
    Random random{1};
    EXPECT_EQ((SpiralCheck{area, path, wish}.run(random)), "");
  }
}

TEST(SpiralPaths, ClearRandomPockets) {
  std::size_t turns = 0;
  std::size_t loops = 0;
  std::size_t rows = 0;
  std::size_t refused = 0;
  for (const std::uint64_t seed : Trials{60}) {
    Random random{seed};
    cnc::pocket::PocketBench bench;
    SpiralWish wish;
    wish.radius_mm = cnc::pocket::add_random_pocket(bench, random);
    wish.corner_mm = random.between(0.02, 0.3) * wish.radius_mm;
    wish.stepover_mm =
        random.between(0.3, 1.0) * sim::pocket::widest_spiral_mm(wish.radius_mm, wish.corner_mm);
    if (random.chance(0.3)) wish.milling = cnc::pocket::Milling::kConventional;
    const sim::Contour area = sim::copy_of(bench.pocket());
    try {
      const SpiralPath path = wish.path_of(area);
      EXPECT_EQ((SpiralCheck{area, path, wish}.run(random)), "") << "KERFLINE_SEED=" << seed;
      turns += path.turns;
      loops += path.loops;
      rows += path.row_ends.size();
    } catch (const sim::pocket::NoPocketPath&) {
      ++refused;  // The tool fits nowhere, or a pass is too short for a ramp.
    }
  }
  std::printf("%zu turns, %zu loops, %zu rows, %zu pockets refused\n", turns, loops, rows, refused);
}

}  // namespace
}  // namespace proof
