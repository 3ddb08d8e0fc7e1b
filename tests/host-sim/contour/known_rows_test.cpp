#include "host-sim/contour/known_rows.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

#include "host-sim/contour/outline.hpp"
#include "tests/host-sim/contour/deviation.hpp"
#include "tests/support/random_source.hpp"
#include "tests/support/trials.hpp"

namespace sim {
namespace {

using drawing::Bezier;
using drawing::DrawnContour;
using drawing::Line;
using drawing::Place;
using drawing::Shape;

/// Returns curves that follow each other smoothly, from the origin on.
std::vector<Bezier> random_row(proof::Random& random, std::size_t curves) {
  std::vector<Bezier> row;
  Place at{0.0, 0.0};
  double heading = random.between(0.0, 2.0 * std::numbers::pi);
  const double size = random.magnitude(0.2, 30.0);
  const auto ahead = [&](double length) -> Place {
    return size * length * Place{std::cos(heading), std::sin(heading)};
  };
  for (std::size_t i = 0; i < curves; ++i) {
    const Place leaves = at + ahead(random.between(0.2, 0.5));
    heading += random.between(-0.6, 0.6);
    const Place end = at + ahead(random.between(0.9, 1.3));
    heading += random.between(-0.6, 0.6);
    const Place arrives = end - ahead(random.between(0.2, 0.5));
    row.push_back({{at, leaves, arrives, end}});
    at = end;
  }
  return row;
}

/// A map of the plane: a rotation by quarter turns or a mirroring, then a shift.
struct Placing {
  std::size_t quarters = 0;
  bool is_mirrored = false;
  Place shift{0.0, 0.0};

  [[nodiscard]] Place operator()(Place place) const {
    if (is_mirrored) place.x() = -place.x();
    for (std::size_t i = 0; i < quarters; ++i) place = Place{-place.y(), place.x()};
    return place + shift;
  }
};

/// Returns a closed contour: the row, and lines back to its beginning.
DrawnContour placed(const std::vector<Bezier>& row, const Placing& placing, bool has_stem) {
  DrawnContour contour;
  contour.closed = true;
  for (const Bezier& curve : row) {
    Bezier moved = curve;
    for (Place& point : moved.points) point = placing(point);
    if (!contour.shapes.empty()) {
      moved.points.front() = std::get<Bezier>(contour.shapes.back()).points.back();
    }
    contour.shapes.emplace_back(moved);
  }
  const Place start = drawing::start_of(contour.shapes.front());
  const Place end = drawing::end_of(contour.shapes.back());
  const Place last = row.back().points[3] - row.back().points[2];
  const Place stem = placing(row.back().points[3] + last);
  if (has_stem) contour.shapes.emplace_back(Line{end, stem});
  contour.shapes.emplace_back(Line{has_stem ? stem : end, start});
  return contour;
}

bool is_same(const FittedContour& one, const FittedContour& other) {
  return !one.fault && !other.fault &&
         std::ranges::equal(
             one.vertices, other.vertices, [](const ContourVertex& a, const ContourVertex& b) {
               return a.x == b.x && a.y == b.y && a.bulge == b.bulge;
             });
}

struct Wish {
  DrawnContour contour;
  OutlineOptions options;
};

/// Returns few rows, each at many positions, and rows that are nearly equal to them.
std::vector<Wish> random_wishes(proof::Random& random) {
  std::vector<Wish> wishes;
  const double tolerance = random.magnitude(0.002, 0.2);
  for (std::size_t i = 0; i < 4; ++i) {
    const auto row = random_row(random, 1 + random.below(4));
    for (std::size_t k = 0; k < 10; ++k) {
      auto changed = row;
      if (random.chance(0.3)) {
        Place& point = changed[random.below(row.size())].points[1 + random.below(2)];
        point.x() += random.signed_magnitude(1.0e-9, 1.0e-2);
      }
      const Placing placing{random.below(4),
                            random.chance(0.3),
                            {random.between(-500.0, 500.0), random.between(-500.0, 500.0)}};
      const OutlineOptions options{.tolerance_mm = random.chance(0.8) ? tolerance : 2.0 * tolerance,
                                   .method = random.chance(0.8)
                                                 ? cnc::contour::FitMethod::kFewest
                                                 : cnc::contour::FitMethod::kBisecting};
      wishes.push_back({placed(changed, placing, random.chance(0.5)), options});
    }
  }
  return wishes;
}

TEST(KnownRows, GiveTheArcsOfEachContourAloneInAnyOrder) {
  for (const std::uint64_t seed : proof::Trials{60}) {
    SCOPED_TRACE("KERFLINE_SEED=" + std::to_string(seed));
    proof::Random random{seed};
    auto wishes = random_wishes(random);
    KnownRows ahead;
    std::vector<FittedContour> found;
    for (const Wish& wish : wishes) found.push_back(arcs_of(wish.contour, wish.options, ahead));
    KnownRows back;
    for (std::size_t i = wishes.size(); i-- > 0;) {
      const Wish& wish = wishes[i];
      ASSERT_TRUE(is_same(found[i], arcs_of(wish.contour, wish.options))) << i;
      ASSERT_TRUE(is_same(found[i], arcs_of(wish.contour, wish.options, back))) << i;
      auto loop = found[i].vertices;
      loop.push_back(loop.front());
      const double tolerance = wish.options.tolerance_mm;
      ASSERT_LE(deviation(wish.contour, loop, tolerance), tolerance) << i;
    }
  }
}

/// Returns how many rows are kept after these contours.
std::size_t kept_after(const std::vector<DrawnContour>& contours) {
  KnownRows rows;
  for (const DrawnContour& contour : contours) static_cast<void>(arcs_of(contour, {}, rows));
  return rows.kept();
}

TEST(KnownRows, KeepARowInManyPlacesOnce) {
  proof::Random random{1};
  const auto row = random_row(random, 3);
  std::vector<DrawnContour> contours;
  for (std::size_t i = 0; i < 20; ++i) {
    // The shifts are multiples of 1/64 mm, which change the binary digits of a point as drawings
    // do.
    const Place shift{1.25 * static_cast<double>(i), 300.0 - 0.015625 * static_cast<double>(i)};
    contours.push_back(placed(row, {.quarters = 0, .is_mirrored = false, .shift = shift}, false));
  }
  const std::size_t one = kept_after({contours.front()});
  EXPECT_LE(kept_after(contours), 2 * one);
  auto other = row;
  other[1].points[1].x() += 1.0e-6;
  contours.push_back(placed(other, {}, false));
  EXPECT_GE(kept_after({contours.front(), contours.back()}), 2 * one - 8);
}

TEST(KnownRows, KeepABoundedNumberOfRows) {
  proof::Random random{1};
  KnownRows rows;
  std::size_t fits = 0;
  std::size_t most = 0;
  for (std::size_t i = 0; i < 20'000; ++i) {
    const Bezier curve = random_row(random, 1).front();
    const std::vector<Shape> shapes{curve};
    const auto shape = RowShape::of(shapes);
    ASSERT_TRUE(shape.has_value());
    const auto fit = [&fits] {
      ++fits;
      return FittedRow{.vertices = std::vector<ContourVertex>(50)};
    };
    EXPECT_EQ(rows.find_or_fit(*shape, fit).vertices.size(), 50U);
    EXPECT_EQ(rows.find_or_fit(*shape, fit).vertices.size(), 50U);
    most = std::max(most, rows.kept());
  }
  EXPECT_EQ(fits, 20'000U);
  EXPECT_GT(most, KnownRows::kMaxKept / 2);
  EXPECT_LE(most, KnownRows::kMaxKept + 200);
}

TEST(RowShape, MovesNoCoordinateByMoreThanItsUnit) {
  proof::Random random{1};
  for (std::size_t i = 0; i < 1'000; ++i) {
    const auto row = random_row(random, 3);
    const std::vector<Shape> shapes{row.begin(), row.end()};
    const auto shape = RowShape::of(shapes);
    ASSERT_TRUE(shape.has_value());
    const auto curves = shape->curves();
    ASSERT_EQ(curves.size(), 3U);
    for (std::size_t k = 0; k < 3; ++k) {
      for (std::size_t j = 0; j < 4; ++j) {
        const Place apart = std::get<Bezier>(curves[k]).points[j] - row[k].points[j];
        ASSERT_LE(apart.cwiseAbs().maxCoeff(), 0.03e-6);
      }
    }
  }
}

TEST(RowShape, IsNoneOfOtherCurvesGapsAndLongRows) {
  proof::Random random{1};
  auto row = random_row(random, 2);
  const std::vector<Shape> with_line{row[0], Line{row[0].points[3], row[1].points[3]}};
  EXPECT_FALSE(RowShape::of(with_line).has_value());
  const auto longest = random_row(random, RowShape::kMaxCurves + 1);
  const std::vector<Shape> shapes{longest.begin(), longest.end()};
  EXPECT_FALSE(RowShape::of(shapes).has_value());
  EXPECT_TRUE(RowShape::of(std::span{shapes}.first(RowShape::kMaxCurves)).has_value());
  row[1].points[0].x() += 1.0e-3;
  const std::vector<Shape> with_gap{row[0], row[1]};
  EXPECT_FALSE(RowShape::of(with_gap).has_value());
  const std::vector<Shape> far{Bezier{{Place{0, 0}, Place{1, 1}, Place{2, 1}, Place{2.0e6, 0}}}};
  EXPECT_FALSE(RowShape::of(far).has_value());
}

}  // namespace
}  // namespace sim
