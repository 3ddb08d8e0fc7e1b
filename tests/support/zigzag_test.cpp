#include "host-sim/pocket/zigzag.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <stdexcept>
#include <string>

#include "host-sim/contour/contour_text.hpp"
#include "host-sim/pocket/pocket_plan.hpp"
#include "tests/planner/pocket/path_bench.hpp"
#include "tests/support/trials.hpp"

namespace proof {
namespace {

using cnc::WideVec2;
using cnc::pocket::PathPoint;
using cnc::pocket::Use;
using sim::pocket::Zigzag;
using sim::pocket::zigzag_path;
using sim::pocket::ZigzagOptions;

/// Finds faults of a path by distances and angles that are computed independently of the planner.
class ZigzagCheck {
 public:
  ZigzagCheck(const sim::Contour& area, const Zigzag& path, const ZigzagOptions& options)
      : path_{path}, options_{options} {
    wall_.add(area.view());
    sim::ContourOffset offsetter;
    locus_ = sim::copy_of(offsetter.offset(area.view(), -options.tool_radius_mm));
    area_ = &area;
    locus_walls_.add(locus_.view());
  }

  std::string run(Random& random) {
    for (std::size_t row = 0; row < path_.row_ends.size(); ++row) check_row(row);
    check_stock(random);
    return complaint_;
  }

 private:
  void complain(const std::string& text) {
    if (complaint_.empty()) complaint_ = text;
  }

  void check_row(std::size_t row) {
    const std::uint32_t begin = path_.path().row_begin(row);
    const std::uint32_t end = path_.row_ends[row];
    if (path_.points[begin].z != 0.0) complain("a row does not begin at the top");
    if (path_.points[end - 1].z != -options_.depth_mm) complain("a row does not end at the floor");
    for (std::uint32_t i = begin; i + 1 < end; ++i) {
      check_element(path_.points[i], path_.points[i + 1]);
      if (i + 2 < end) check_joint(path_.points[i], path_.points[i + 1], path_.points[i + 2]);
    }
  }

  void check_element(const PathPoint<double>& from, const PathPoint<double>& to) {
    const double length = cnc::pocket::flat_length(from, to);
    const double drop = from.z - to.z;
    if (from.use == Use::kPass && drop != 0.0) complain("a pass that changes its depth");
    if (drop < 0.0) complain("a way up");
    if (drop > options_.slope * length * (1.0 + 1.0e-9) + 1.0e-12) complain("too steep");
    if (length == 0.0) return;
    const cnc::contour::exact::PlainArc arc{cnc::pocket::arc_of(from, to)};
    for (const double share : {0.0, 0.13, 0.37, 0.5, 0.71, 0.93}) {
      const WideVec2 place = arc.at(share);
      const double away = wall_.distance(place);
      if (away < options_.tool_radius_mm - 1.0e-6) {
        complain("gouges by " + std::to_string(options_.tool_radius_mm - away));
      }
    }
    if (!wall_.encloses(arc.at(0.4))) complain("is outside of the pocket");
  }

  /// Checks that the path has corners only at the wall and where a ramp reverses.
  void check_joint(const PathPoint<double>& a,
                   const PathPoint<double>& b,
                   const PathPoint<double>& c) {
    if (options_.turn_radius_mm == 0.0 || a.use == Use::kEntry) return;
    if (cnc::pocket::flat_length(a, b) < 1.0e-4 || cnc::pocket::flat_length(b, c) < 1.0e-4) return;
    if (cnc::pocket::kink_between(a, b, c) < 0.02) return;
    if (locus_walls_.distance(b.point()) > 1.0e-6) {
      complain("a corner of " + std::to_string(cnc::pocket::kink_between(a, b, c)) +
               " degrees at " + std::to_string(b.x) + " " + std::to_string(b.y));
    }
  }

  void check_stock(Random& random) {
    cnc::pocket::PocketOracle oracle{area_->view(), locus_.view(), options_.tool_radius_mm};
    cnc::pocket::for_each_element(path_.path(), [&](const auto& from, const auto& to) {
      if (from.use == Use::kPass) oracle.add_pass_element(cnc::pocket::arc_of(from, to));
    });
    const double far = oracle.farthest(random, 200) - options_.tool_radius_mm;
    if (far > 1.0e-6) complain("leaves " + std::to_string(far) + " mm");
  }

  const Zigzag& path_;
  ZigzagOptions options_;
  const sim::Contour* area_ = nullptr;
  sim::Contour locus_;
  cnc::pocket::PlainContour wall_;
  cnc::pocket::PlainContour locus_walls_;
  std::string complaint_;
};

std::string faults_of(const char* text, const ZigzagOptions& options, std::size_t rows) {
  const sim::Contour area = sim::contour_from_text(text, "test");
  const Zigzag path = zigzag_path(area.view(), options);
  EXPECT_EQ(path.row_ends.size(), rows);
  Random random{1};
  return ZigzagCheck{area, path, options}.run(random);
}

constexpr const char* kRoom = "0 0\n60 0\n60 40\n0 40\nclosed\n";

TEST(ZigzagPaths, ClearARoomInOneRowAndOnePassAlongTheWall) {
  EXPECT_EQ(faults_of(kRoom, {}, 2), "");
  EXPECT_EQ(faults_of(kRoom, {.turn_radius_mm = 0.0}, 2), "");
  EXPECT_EQ(faults_of(kRoom, {.stepover_mm = 6.0, .turn_radius_mm = 1.0}, 2), "");
  EXPECT_EQ(faults_of("40 0 1\n-40 0 1\nclosed\n", {}, 2), "");
}

TEST(ZigzagPaths, HaveEquallyDistantLines) {
  const sim::Contour area = sim::contour_from_text(kRoom, "test");
  // The lines lie between 3 and 37 mm, 34 / 12 mm apart.
  EXPECT_EQ(zigzag_path(area.view(), {}).lines, 11U);
  EXPECT_EQ(zigzag_path(area.view(), {.stepover_mm = 6.0}).lines, 5U);
}

TEST(ZigzagPaths, ClearAroundAnIsland) {
  EXPECT_EQ(
      faults_of("0 0\n80 0\n80 50\n0 50\nclosed\n30 20\n30 30\n50 30\n50 20\nclosed\n", {}, 4), "");
}

TEST(ZigzagPaths, PlungeWhereAsked) {
  const sim::Contour area = sim::contour_from_text(kRoom, "test");
  const Zigzag path = zigzag_path(area.view(), {.plunges = true});
  EXPECT_EQ(path.points[0].point(), path.points[1].point());
  EXPECT_EQ(path.points[1].z, -1.0);
  EXPECT_EQ(path.row_ends.size(), 2U);
}

TEST(ZigzagPaths, RefuseWhatCannotBe) {
  const sim::Contour area = sim::contour_from_text(kRoom, "test");
  for (const ZigzagOptions& options : {ZigzagOptions{.tool_radius_mm = 0.0},
                                       ZigzagOptions{.stepover_mm = 6.1},
                                       ZigzagOptions{.stepover_mm = 0.0},
                                       ZigzagOptions{.turn_radius_mm = -1.0},
                                       ZigzagOptions{.depth_mm = 0.0},
                                       ZigzagOptions{.slope = 0.0}}) {
    EXPECT_THROW(static_cast<void>(zigzag_path(area.view(), options)), std::invalid_argument);
  }
  EXPECT_THROW(static_cast<void>(zigzag_path(area.view(), {.tool_radius_mm = 21.0})),
               sim::pocket::NoPocketPath);
}

TEST(ZigzagPaths, ClearRandomPockets) {
  std::size_t rows = 0;
  std::size_t lines = 0;
  for (const std::uint64_t seed : Trials{100}) {
    Random random{seed};
    cnc::pocket::PocketBench bench;
    ZigzagOptions options;
    options.tool_radius_mm = cnc::pocket::add_random_pocket(bench, random);
    options.stepover_mm = random.between(0.3, 2.0) * options.tool_radius_mm;
    const double turn = random.chance(0.2) ? 0.0 : random.between(0.01, 0.33);
    options.turn_radius_mm = turn * options.tool_radius_mm;
    options.depth_mm = 0.1 * options.tool_radius_mm;
    const sim::Contour area = sim::copy_of(bench.pocket());
    try {
      const Zigzag path = zigzag_path(area.view(), options);
      EXPECT_EQ((ZigzagCheck{area, path, options}.run(random)), "") << "KERFLINE_SEED=" << seed;
      rows += path.row_ends.size();
      lines += path.lines;
    } catch (const sim::pocket::NoPocketPath&) {
      // The tool fits nowhere, or a wall is too short for a ramp.
    }
  }
  std::printf("%zu lines in %zu rows\n", lines, rows);
}

}  // namespace
}  // namespace proof
