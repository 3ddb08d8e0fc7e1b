#include "host-sim/pocket/rest_path.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <numbers>
#include <string>

#include "host-sim/contour/contour_text.hpp"
#include "host-sim/pocket/strategy.hpp"
#include "tests/planner/pocket/path_bench.hpp"
#include "tests/support/trials.hpp"

namespace proof {
namespace {

using cnc::WideVec2;
using cnc::pocket::Milling;
using cnc::pocket::PathPoint;
using cnc::pocket::Use;
using sim::pocket::MilledPocket;
using sim::pocket::StrategyOptions;

constexpr double kRestRoundingMm = 1.0e-6;

StrategyOptions options_of(double radius_mm, double former_radius_mm) {
  StrategyOptions options;
  options.pocket.clearing = {
      .tool_radius = radius_mm, .corner_radius = 0.1 * radius_mm, .stepover = 2.0 * radius_mm};
  options.pocket.entry = {cnc::pocket::EntryKind::kHelix, 0.05, 0.9 * radius_mm};
  options.pocket.depth = options.pocket.depth_step = 0.1 * radius_mm;
  options.former_radius_mm = former_radius_mm;
  return options;
}

MilledPocket rest_of(const sim::Contour& area, const StrategyOptions& options) {
  sim::pocket::StrategyPlanner planner{options};
  return planner.mill(area.view(), options.pocket.clearing.tool_radius);
}

/// Finds faults of a rest path by distances and samples that are computed independently of the
/// planner.
class RestCheck {
 public:
  RestCheck(const sim::Contour& area, const MilledPocket& path, const StrategyOptions& options)
      : path_{path},
        radius_{options.pocket.clearing.tool_radius},
        former_radius_{options.former_radius_mm},
        slope_{options.pocket.entry.slope},
        depth_{options.pocket.depth},
        locus_{offset(area, -radius_)},
        oracle_{area.view(), locus_.view(), radius_} {
    former_.add(offset(area, -former_radius_).view());
    cnc::pocket::for_each_element(path.path(), [this](const auto& from, const auto& to) {
      if (from.use == Use::kPass && cnc::pocket::flat_length(from, to) > 0.0) {
        passes_.add_element(cnc::pocket::arc_of(from, to));
      }
    });
  }

  std::string run(Random& random) {
    for (std::size_t row = 0; row < path_.row_ends.size(); ++row) check_row(row);
    for (int i = 0; i < 400; ++i) check_stock(random);
    return complaint_;
  }

  /// Returns the number of sampled points that the former tool left uncut.
  [[nodiscard]] std::size_t places_left() const { return places_left_; }

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
    if (path_.points[begin].z != 0.0) complain("no row from the top", path_.points[begin].point());
    if (path_.points[end - 1].z != -depth_) complain("no floor", path_.points[begin].point());
    for (std::uint32_t i = begin; i + 1 < end; ++i) {
      check_element(path_.points[i], path_.points[i + 1]);
    }
  }

  void check_element(const PathPoint<double>& from, const PathPoint<double>& to) {
    const double length = cnc::pocket::flat_length(from, to);
    const double drop = from.z - to.z;
    if (drop < 0.0) complain("a way up", from.point());
    if (drop > 0.0 && from.use == Use::kLink) {
      if (length > 0.0) complain("a link that descends", from.point());
      return check_free(from.point());
    }
    if (from.use == Use::kPass && drop != 0.0) complain("a pass that descends", from.point());
    if (drop > slope_ * length * (1.0 + 1.0e-9) + 1.0e-12) complain("too steep", from.point());
    if (length == 0.0) return;
    const cnc::contour::exact::PlainArc arc{cnc::pocket::arc_of(from, to)};
    for (const double share : {0.0, 0.13, 0.37, 0.5, 0.71, 0.93}) {
      const WideVec2 place = arc.at(share);
      const double away = oracle_.wall().distance(place);
      if (away < radius_ - kRestRoundingMm) {
        complain("gouges by " + std::to_string(radius_ - away), place);
      }
    }
    // Near the beginning of a wall, the wall's chord may pass through the point, so that a test
    // there proves nothing. The point at 0.4 is tested instead.
    if (!oracle_.wall().encloses(arc.at(0.4))) complain("outside of the pocket", arc.at(0.4));
  }

  /// Returns whether the former tool removed the stock at a point, or within a distance of it.
  [[nodiscard]] bool is_cleared(const WideVec2& place, double within_mm) const {
    if (former_.empty()) return false;
    return former_.encloses(place) || former_.distance(place) <= former_radius_ + within_mm;
  }

  /// Checks that the tool meets no stock when it plunges here.
  void check_free(const WideVec2& place) {
    constexpr int kAround = 48;
    for (int i = 0; i < kAround; ++i) {
      const double angle = 2.0 * std::numbers::pi * i / kAround;
      const WideVec2 rim = place + radius_ * WideVec2{std::cos(angle), std::sin(angle)};
      if (!is_cleared(rim, kRestRoundingMm)) complain("a plunge into stock", place);
    }
  }

  /// Checks the cut at a random point near the wall, where the rest lies.
  void check_stock(Random& random) {
    const cnc::pocket::PlainContour& wall = oracle_.wall();
    const WideVec2 foot = wall.at(random.below(wall.size()), random.between(0.0, 1.0));
    const double angle = random.between(0.0, 2.0 * std::numbers::pi);
    const WideVec2 place =
        foot + random.between(0.0, former_radius_) * WideVec2{std::cos(angle), std::sin(angle)};
    if (!oracle_.is_reachable(place)) return;
    if (is_cleared(place, sim::pocket::kThinRestMm + kRestRoundingMm)) return;
    ++places_left_;
    const double away = passes_.empty() ? 1.0e9 : passes_.distance(place);
    if (away > radius_ + kRestRoundingMm) {
      complain("leaves stock, " + std::to_string(away - radius_) + " mm from the tool", place);
    }
  }

  const MilledPocket& path_;
  double radius_;
  double former_radius_;
  double slope_;
  double depth_;
  sim::Contour locus_;
  cnc::pocket::PocketOracle oracle_;
  cnc::pocket::PlainContour former_;
  cnc::pocket::PlainContour passes_;
  std::size_t places_left_ = 0;
  std::string complaint_;
};

constexpr const char* kRestRoom = "0 0\n60 0\n60 40\n0 40\nclosed\n";

TEST(RestPaths, MillTheCornersOfARoom) {
  const sim::Contour area = sim::contour_from_text(kRestRoom, "test");
  const StrategyOptions options = options_of(1.5, 3.0);
  const MilledPocket path = rest_of(area, options);
  // Each corner requires only one pass: its rest extends to at most 1.8 mm from the corner.
  EXPECT_EQ(path.passes, 4U);
  EXPECT_EQ(path.row_ends.size(), 4U);
  for (const auto& point : path.points) {
    const double to_corner =
        std::hypot(std::min(point.x, 60.0 - point.x), std::min(point.y, 40.0 - point.y));
    EXPECT_LT(to_corner, 6.0);
  }
  Random random{1};
  RestCheck check{area, path, options};
  EXPECT_EQ(check.run(random), "");
  EXPECT_GT(check.places_left(), 0U);
}

TEST(RestPaths, RunAgainstTheLoopsWhereAsked) {
  const sim::Contour area = sim::contour_from_text(kRestRoom, "test");
  StrategyOptions options = options_of(1.5, 3.0);
  options.pocket.milling = Milling::kConventional;
  const MilledPocket path = rest_of(area, options);
  EXPECT_EQ(path.row_ends.size(), 4U);
  Random random{1};
  EXPECT_EQ((RestCheck{area, path, options}.run(random)), "");
  // The first element at the wall in the first row runs clockwise about the middle of the room.
  const PathPoint<double>& from = path.points[2];
  const PathPoint<double>& to = path.points[3];
  EXPECT_LT(cnc::cross(from.point() - WideVec2{30.0, 20.0}, to.point() - from.point()), 0.0);
}

TEST(RestPaths, AreEmptyWhereNothingIsLeft) {
  const sim::Contour circle = sim::contour_from_text("20 0 1\n-20 0 1\nclosed\n", "test");
  EXPECT_TRUE(rest_of(circle, options_of(1.5, 3.0)).points.empty());
}

TEST(RestPaths, AreTheWholePocketWhereTheFormerToolDidNotFit) {
  const sim::Contour area = sim::contour_from_text(kRestRoom, "test");
  StrategyOptions options = options_of(1.5, 25.0);
  const MilledPocket all = rest_of(area, options);
  options.former_radius_mm = 0.0;
  EXPECT_EQ(all.points.size(), rest_of(area, options).points.size());
}

TEST(RestPaths, MillRoomsBehindNarrowDoors) {
  // The former tool cannot leave the room on the left; the room on the right gets passes all
  // around.
  const sim::Contour area = sim::contour_from_text(
      "0 0\n40 0\n40 18\n50 18\n50 12\n62 12\n62 28\n50 28\n50 22\n40 22\n40 40\n0 40\nclosed\n",
      "test");
  const StrategyOptions options = options_of(1.5, 9.0);
  const MilledPocket path = rest_of(area, options);
  Random random{1};
  RestCheck check{area, path, options};
  EXPECT_EQ(check.run(random), "");
  EXPECT_GT(check.places_left(), 50U);
}

TEST(RestPaths, MillWhatIsLeftOfRandomPockets) {
  std::size_t pieces = 0;
  std::size_t places = 0;
  std::size_t refused = 0;
  for (const std::uint64_t seed : Trials{60}) {
    Random random{seed};
    cnc::pocket::PocketBench bench;
    const double radius = cnc::pocket::add_random_pocket(bench, random);
    StrategyOptions options = options_of(radius, random.between(1.05, 4.0) * radius);
    if (random.chance(0.3)) options.pocket.milling = Milling::kConventional;
    const sim::Contour area = sim::copy_of(bench.pocket());
    try {
      const MilledPocket path = rest_of(area, options);
      RestCheck check{area, path, options};
      EXPECT_EQ(check.run(random), "") << "KERFLINE_SEED=" << seed;
      pieces += path.passes;
      places += check.places_left();
    } catch (const sim::pocket::NoPocketPath&) {
      ++refused;  // The tool fits nowhere, or a part of the area is too short for a ramp.
    }
  }
  std::printf(
      "%zu parts of passes, %zu places with stock, %zu pockets refused\n", pieces, places, refused);
}

}  // namespace
}  // namespace proof
