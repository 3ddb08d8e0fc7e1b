#include "host-sim/cut/narrow_lines.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <string>

#include "tests/host-sim/cut/burnt_sheet.hpp"
#include "tests/host-sim/cut/support.hpp"
#include "tests/support/random_source.hpp"
#include "tests/support/trials.hpp"

namespace sim::cut {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

constexpr double kEverything = kHalf;

CutPlan plan_of_svg(const std::string& content, double narrow_mm) {
  return plan_of(drawing::read(drawing::svg_of(content)), {.narrow_mm = narrow_mm});
}

std::string plate_with(const std::string& holes) {
  return "<rect x=\"5\" y=\"5\" width=\"90\" height=\"90\"/>" + holes;
}

std::string slot(double length, double width, double angle_deg) {
  return fmt::format(
      "<rect x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\" "
      "transform=\"translate(50 50) rotate({})\"/>",
      -0.5 * length,
      -0.5 * width,
      length,
      width,
      angle_deg);
}

TEST(NarrowLines, CutASlotOnceAlongItsMiddle) {
  proof::Trials trials{20};
  for (const auto trial : trials) {
    proof::Random random{trial};
    const double width = random.between(0.02, 0.98) * kTestKerf;
    const double length = random.between(2.0, 30.0);
    const double angle = random.between(-90.0, 90.0);
    const CutPlan plan = plan_of_svg(plate_with(slot(length, width, angle)), kEverything);
    ASSERT_THAT(plan.faults, IsEmpty());
    ASSERT_THAT(plan.cuts, SizeIs(2));
    const Cut& cut = plan.cuts.front();
    EXPECT_TRUE(cut.is_hole);
    // The beam reaches the ends of the slot.
    EXPECT_NEAR(length_of(cut.strokes), length - kTestKerf, 0.02);
    const Place along = drawing::direction(-angle * std::numbers::pi / 180.0);
    const Place middle = 0.5 * (cut.start() + cut.end());
    for (const Stroke& stroke : cut.strokes) {
      EXPECT_NEAR(drawing::cross(along, stroke.to - middle), 0.0, 0.01);
    }
    ASSERT_THAT(plan.warnings, SizeIs(1));
    const std::string told = fmt::format("up to {:.3f} mm off", kHalf - 0.5 * width);
    EXPECT_THAT(plan.warnings[0].reason, HasSubstr(told));
  }
}

TEST(NarrowLines, CrossAtTheMiddleOfACross) {
  constexpr const char* kCross =
      "<path d=\"M45 49.9H49.9V45H50.1V49.9H55V50.1H50.1V55H49.9V50.1H45Z\"/>";
  const CutPlan plan = plan_of_svg(plate_with(kCross), kEverything);
  EXPECT_THAT(plan.faults, IsEmpty());
  ASSERT_THAT(plan.cuts, SizeIs(3)) << "two lines and the plate";
  for (const Cut& cut : {plan.cuts[0], plan.cuts[1]}) {
    EXPECT_NEAR(length_of(cut.strokes), 10.0 - kTestKerf, 0.05);
    EXPECT_NEAR(drawing::distance(cut.start(), cut.end()), 10.0 - kTestKerf, 0.05);
  }
}

/// The beam does not reach the corners of the holes, so the slots must be cut up to these corners.
TEST(NarrowLines, LeadToTheEndOfASlotAtTheCornerOfAHole) {
  for (const double gap : {0.001, 0.005, 0.009}) {
    SCOPED_TRACE(gap);
    const auto slot_at = [gap](double y) {
      return fmt::format(
          R"(<rect x="{}" y="{}" width="{}" height="0.03"/>)", 30.0 + gap, y, 30.0 - 2.0 * gap);
    };
    const CutPlan plan = plan_of_svg(plate_with(R"(<rect x="20" y="40" width="10" height="20"/>)"
                                                R"(<rect x="60" y="40" width="10" height="20"/>)" +
                                                slot_at(40.0) + slot_at(59.97)),
                                     kEverything);
    EXPECT_THAT(plan.faults, IsEmpty());
    EXPECT_FALSE(BurntSheet{plan}.are_one({45.0, 50.0}, {50.0, 10.0}));
  }
}

TEST(NarrowLines, GoThroughAHoleSmallerThanTheKerf) {
  const CutPlan plan = plan_of_svg(plate_with("<circle cx=\"30\" cy=\"60\" r=\"0.2\"/>"), 0.11);
  EXPECT_THAT(plan.faults, IsEmpty());
  ASSERT_THAT(plan.cuts, SizeIs(2));
  EXPECT_NEAR(length_of(plan.cuts[0].strokes), 0.5 * kHalf, 1.0e-6);
  const Place middle = 0.5 * (plan.cuts[0].start() + plan.cuts[0].end());
  EXPECT_NEAR(middle.x(), 30.0, 1.0e-3);
  EXPECT_NEAR(middle.y(), 40.0, 1.0e-3);
  EXPECT_THAT(plan_of_svg(plate_with("<circle cx=\"30\" cy=\"60\" r=\"0.2\"/>"), 0.09).faults,
              SizeIs(1))
      << "farther into the edge than allowed";
}

/// In the outlines of these lenses as arcs, a tip turns back by a tiny distance.
TEST(NarrowLines, StayInAHoleWhoseOutlineTurnsBackByAHair) {
  struct Lens {
    double angle_deg;
    double length;
    const char* path;
  };
  constexpr std::array kLenses{
      Lens{36.10, 3.868, "M0 0C0.396 -0.036 2.868 0.087 3.868 0C2.900 0.000 1.140 -0.123 0 0Z"},
      Lens{85.45, 5.559, "M0 0C1.003 -0.283 4.943 0.080 5.559 0C4.957 0.000 1.331 -0.363 0 0Z"},
      Lens{33.07, 4.802, "M0 0C1.083 -0.111 4.202 0.064 4.802 0C3.601 0.000 1.882 -0.174 0 0Z"},
      Lens{79.20, 6.847, "M0 0C2.064 -0.792 5.123 0.030 6.847 0C5.797 0.000 1.657 -0.821 0 0Z"}};
  for (const Lens& lens : kLenses) {
    SCOPED_TRACE(lens.path);
    const std::string hole =
        fmt::format("<path transform=\"translate(50 50) rotate({:.2f})\" d=\"{}\"/>",
                    lens.angle_deg,
                    lens.path);
    const CutPlan plan = plan_of_svg(plate_with(hole), kEverything);
    EXPECT_THAT(plan.faults, IsEmpty());
    ASSERT_THAT(plan.cuts, SizeIs(2));
    const Place along = drawing::direction(-lens.angle_deg * std::numbers::pi / 180.0);
    const Cut& cut = plan.cuts.front();
    EXPECT_NEAR(length_of(cut.strokes), lens.length - kTestKerf, 0.1);
    for (const Stroke& stroke : cut.strokes) {
      for (const Place& place : places_along(stroke, 0.1)) {
        const Place off = place - Place{50.0, 50.0};
        EXPECT_LT(std::abs(drawing::cross(along, off)), 0.5);
        EXPECT_GT(drawing::dot(along, off), 0.0);
        EXPECT_LT(drawing::dot(along, off), lens.length);
      }
    }
  }
}

TEST(NarrowLines, PartNeighboursThatAreNearerThanTheKerf) {
  constexpr const char* kNeighbours =
      "<rect x=\"0\" y=\"0\" width=\"10\" height=\"10\"/>"
      "<rect x=\"10.4\" y=\"0\" width=\"10\" height=\"10\"/>";
  const CutPlan plan = plan_of_svg(kNeighbours, 0.101);
  EXPECT_THAT(plan.faults, IsEmpty());
  ASSERT_THAT(plan.cuts, SizeIs(2)) << "the line between them, then the way around both";
  EXPECT_NEAR(plan.cuts[0].start().x(), 10.2, 0.01);
  EXPECT_NEAR(length_of(plan.cuts[0].strokes), 10.0, 0.5);
  EXPECT_NEAR(plan.cuts[1].area_mm2, 20.4 * 10.0 + 2.0 * (20.4 + 10.0) * kHalf, 1.0);
  ASSERT_THAT(plan.warnings, SizeIs(1));
  EXPECT_THAT(plan.warnings[0].reason, HasSubstr("up to 0.100 mm off"));
  const CutPlan refused = plan_of_svg(kNeighbours, 0.099);
  ASSERT_THAT(refused.faults, SizeIs(2));
  EXPECT_THAT(refused.faults[0].remedy, HasSubstr("--narrow 0.100"));
}

/// Returns a star of random corners, which may be long and thin, in a cell of a plate.
std::vector<Place> random_star(proof::Random& random, const Place& middle) {
  std::vector<Place> corners(3 + random.below(6));
  const double first = random.between(0.0, drawing::kFullTurn);
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const double share =
        (static_cast<double>(i) + random.between(0.1, 0.9)) / static_cast<double>(corners.size());
    const double radius = random.chance(0.5) ? random.between(0.05, 0.6) : random.between(0.6, 6.0);
    corners[i] = middle + radius * drawing::direction(first + drawing::kFullTurn * share);
  }
  return corners;
}

std::string path_of(const std::vector<Place>& corners) {
  std::string path = "<path d=\"M";
  for (const Place& corner : corners)
    path += fmt::format("{:.6f} {:.6f} ", corner.x(), 100.0 - corner.y());
  return path + "Z\" fill=\"none\" stroke=\"black\"/>";
}

/// Without a limit, all edges of holes of any shape are cut. No cut is nearer to an edge than
/// allowed.
TEST(NarrowLines, CutAllEdgesOfRandomHolesAsFarAsAllowed) {
  proof::Trials trials{30};
  for (const auto trial : trials) {
    proof::Random random{trial};
    std::vector<Outline> stars;
    std::string holes;
    for (const double x : {25.0, 50.0, 75.0}) {
      for (const double y : {25.0, 50.0, 75.0}) {
        stars.push_back(random_star(random, {x, y}));
        holes += path_of(stars.back());
      }
    }
    const bool is_limited = random.chance(0.5);
    const double narrow_mm = is_limited ? random.between(0.01, 0.9) * kHalf : kEverything;
    const CutPlan plan = plan_of_svg(plate_with(holes), narrow_mm);
    std::vector<Place> cuts;
    for (const Cut& cut : plan.cuts) {
      const bool is_point = length_of(cut.strokes) < 0.51 * kHalf;
      const double least = kHalf - narrow_mm - (is_point ? 0.25 * kHalf : 0.0) - 5.0e-3 * kTestKerf;
      for (const Stroke& stroke : cut.strokes) {
        if (stroke.purpose != Purpose::kContour) continue;
        for (const Place& place : places_along(stroke, 0.02)) {
          cuts.push_back(place);
          ASSERT_GE(distance_to_all(stars, place), least) << trial << ' ' << place.transpose();
        }
      }
    }
    if (is_limited) continue;
    EXPECT_THAT(plan.faults, IsEmpty()) << trial;
    for (const Outline& star : stars) {
      for (std::size_t i = 0; i < star.size(); ++i) {
        for (const Place& place : places_along({star[i], star[(i + 1) % star.size()]}, 0.05)) {
          double nearest = std::numeric_limits<double>::infinity();
          for (const Place& cut : cuts) nearest = std::min(nearest, (cut - place).squaredNorm());
          ASSERT_LE(std::sqrt(nearest), kTestKerf + 0.03) << trial << ' ' << place.transpose();
        }
      }
    }
  }
}

}  // namespace
}  // namespace sim::cut
