#include "host-sim/sheet/sheet_check.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "host-sim/import/curve_measure.hpp"
#include "tests/host-sim/sheet/support.hpp"
#include "tests/support/random_source.hpp"
#include "tests/support/trials.hpp"

namespace sim::sheet {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

const TestFiles kCheckFiles{
    {"square.svg", drawing::svg_of(R"(<rect x="0" y="80" width="20" height="20"/>)")},
    {"disc.svg", drawing::svg_of(R"(<circle cx="10" cy="90" r="10"/>)")},
    {"frame.svg",
     drawing::svg_of(
         R"(<rect x="0" y="20" width="80" height="80"/>
            <rect x="10" y="30" width="60" height="60"/>)")},
    {"wave.svg", drawing::svg_of(R"(<path d="M0 100C30 60 40 60 60 100Z"/>)")}};

std::vector<std::string> wrong_places(const std::string& parts) {
  const drawing::Drawing drawn = placed(sheet_with(parts), kCheckFiles);
  return texts_of(check_places(drawn, edges_of(drawn)));
}

std::string square_at(const char* name, double x, double y) {
  return fmt::format(
      R"({{"drawing": "square.svg", "name": "{}", "x_mm": {}, "y_mm": {}}})", name, x, y);
}

TEST(SheetCheck, PartsThatOverlapTouchOrComeTooNearAreNamed) {
  const std::string first = square_at("a", 0.0, 0.0) + ",";
  EXPECT_THAT(wrong_places(first + square_at("b", 20.5, 0.0)), IsEmpty());
  EXPECT_THAT(wrong_places(first + square_at("b", 20.3, 0.0)), ElementsAre(HasSubstr("b at 20.")));
  EXPECT_THAT(wrong_places(first + square_at("b", 20.3, 0.0)),
              ElementsAre(HasSubstr("is 0.300 mm from a, nearer than the kerf of 0.500 mm; move")));
  EXPECT_THAT(wrong_places(first + square_at("b", 20.0, 0.0)),
              ElementsAre(HasSubstr("is 0.000 mm from a, nearer")));
  EXPECT_THAT(wrong_places(first + square_at("b", 20.0, 3.0)),
              ElementsAre(HasSubstr("is 0.000 mm from a, nearer")));
  EXPECT_THAT(wrong_places(first + square_at("b", 15.0, 7.0)),
              ElementsAre(HasSubstr("overlaps a")));
  EXPECT_THAT(wrong_places(first + square_at("b", 0.0, 0.0)), ElementsAre(HasSubstr("overlaps a")));
  EXPECT_THAT(wrong_places(first + square_at("b", 5.0, 0.0)), ElementsAre(HasSubstr("overlaps a")));
}

TEST(SheetCheck, PartsLieInHolesButNotOnMaterial) {
  const std::string frame = R"({"drawing": "frame.svg", "name": "f"},)";
  EXPECT_THAT(wrong_places(frame + square_at("in", 20.0, 30.0)), IsEmpty());
  EXPECT_THAT(wrong_places(frame + square_at("in", 10.2, 30.0)),
              ElementsAre(HasSubstr("is 0.200 mm")));
  EXPECT_THAT(wrong_places(R"({"drawing": "square.svg", "name": "big", "x_mm": 1, "y_mm": 1},
                              {"drawing": "frame.svg", "name": "f"})"),
              ElementsAre(HasSubstr("overlaps big")));
  // The part is completely on the material, without a crossing.
  const TestFiles files{
      {"plate.svg", drawing::svg_of(R"(<rect x="0" y="20" width="80" height="80"/>)")},
      {"square.svg", kCheckFiles.at("square.svg")}};
  const drawing::Drawing drawn = placed(
      sheet_with(R"({"drawing": "plate.svg"}, {"drawing": "square.svg", "x_mm": 30, "y_mm": 30})"),
      files);
  EXPECT_THAT(texts_of(check_places(drawn, edges_of(drawn))),
              ElementsAre("test.json: square at 30.000 50.000: overlaps plate; move one of them"));
}

TEST(SheetCheck, PartsBeyondTheStockAreToldByTheFarthestPlace) {
  EXPECT_THAT(wrong_places(square_at("a", 180.0, 80.0)), IsEmpty());
  EXPECT_THAT(wrong_places(square_at("a", 182.0, 80.0)),
              ElementsAre(HasSubstr(
                  "is 2.000 mm beyond the right edge of the stock, 200 by 100 mm; move")));
  EXPECT_THAT(wrong_places(square_at("a", -1.0, 90.0)),
              ElementsAre(HasSubstr("is 10.000 mm beyond the upper edge")));
  EXPECT_THAT(wrong_places(R"({"drawing": "disc.svg", "x_mm": -0.5})"),
              ElementsAre(HasSubstr("disc at -0.500 10.000: is 0.500 mm beyond the left edge")));
}

/// Distance and overlap of two convex or bowed outlines, found by trying all of their points.
struct Looked {
  double distance_mm = 1.0e9;
  bool overlap = false;
};

bool lies_within(const std::vector<drawing::Place>& outline, const drawing::Place& at) {
  bool inside = false;
  for (std::size_t i = 1; i < outline.size(); ++i) {
    const auto& a = outline[i - 1];
    const auto& b = outline[i];
    if ((a.y() <= at.y()) == (b.y() <= at.y())) continue;
    if (at.x() < a.x() + (at.y() - a.y()) / (b.y() - a.y()) * (b.x() - a.x())) inside = !inside;
  }
  return inside;
}

std::vector<drawing::Place> dense(const drawing::DrawnContour& contour) {
  const std::vector<drawing::Place> outline = drawing::outline_of(contour.shapes, 1.0e-4);
  std::vector<drawing::Place> places{outline.front()};
  for (std::size_t i = 1; i < outline.size(); ++i) {
    const int count = 1 + static_cast<int>(drawing::distance(outline[i - 1], outline[i]) / 0.05);
    for (int k = 1; k <= count; ++k) {
      places.push_back(outline[i - 1] + (outline[i] - outline[i - 1]) * (k / double{1.0 * count}));
    }
  }
  return places;
}

double distance_to_segment(const drawing::Place& at,
                           const drawing::Place& from,
                           const drawing::Place& to) {
  const drawing::Place way = to - from;
  const double square = way.squaredNorm();
  const double share = square > 0.0 ? std::clamp((at - from).dot(way) / square, 0.0, 1.0) : 0.0;
  return drawing::distance(at, from + share * way);
}

/// Returns the distance from corners to edges. Of two polygons that do not cross, a corner of one
/// is nearest to an edge of the other.
double distance_from_corners(const std::vector<drawing::Place>& corners,
                             const std::vector<drawing::Place>& edges) {
  double least = 1.0e9;
  for (const auto& corner : corners) {
    for (std::size_t i = 1; i < edges.size(); ++i) {
      least = std::min(least, distance_to_segment(corner, edges[i - 1], edges[i]));
    }
  }
  return least;
}

Looked look_at_all(const drawing::Drawing& drawn) {
  constexpr double kFlat = 1.0e-4;
  const auto polygon_a = drawing::outline_of(drawn.contours[0].shapes, kFlat);
  const auto polygon_b = drawing::outline_of(drawn.contours[1].shapes, kFlat);
  Looked looked;
  looked.distance_mm = std::min(distance_from_corners(polygon_a, polygon_b),
                                distance_from_corners(polygon_b, polygon_a));
  const auto a = dense(drawn.contours[0]);
  const auto b = dense(drawn.contours[1]);
  for (const auto& p : a) looked.overlap = looked.overlap || lies_within(b, p);
  for (const auto& q : b) looked.overlap = looked.overlap || lies_within(a, q);
  return looked;
}

TEST(SheetCheck, AgreesWithLookingAtEveryPlace) {
  for (const std::uint64_t seed : proof::Trials{60}) {
    proof::Random random{seed};
    const char* names[] = {"square.svg", "disc.svg", "wave.svg"};
    const auto part = [&](const char* name) {
      return fmt::format(
          R"({{"drawing": "{}", "name": "{}", "x_mm": {}, "y_mm": {},
               "angle_deg": {}, "mirror": {}}})",
          names[static_cast<std::size_t>(random.between(0.0, 2.999))],
          name,
          random.between(0.0, 30.0),
          random.between(0.0, 30.0),
          random.between(-180.0, 180.0),
          random.chance(0.5));
    };
    const drawing::Drawing drawn = placed(sheet_with(part("a") + "," + part("b")), kCheckFiles);
    ASSERT_EQ(drawn.contours.size(), 2U);
    const Looked looked = look_at_all(drawn);
    const std::vector<PartPair> pairs = near_parts(drawn, edges_of(drawn), 10);
    constexpr double kLookSlack = 2.0 * kSheetChordMm;
    if (looked.overlap) {
      // An overlap that is smaller than the spacing of the points may be reported as a distance
      // that is too small.
      ASSERT_EQ(pairs.size(), 1U) << seed;
    } else if (looked.distance_mm < 0.5 - kLookSlack) {
      ASSERT_EQ(pairs.size(), 1U) << seed;
      EXPECT_FALSE(pairs[0].overlap && looked.distance_mm > kLookSlack) << seed;
      EXPECT_NEAR(pairs[0].distance_mm, looked.distance_mm, kLookSlack) << seed;
    } else if (looked.distance_mm > 0.5 + kLookSlack) {
      EXPECT_TRUE(pairs.empty()) << seed;
    }
  }
}

}  // namespace
}  // namespace sim::sheet
