#include "planner/contour/offset.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <memory>
#include <numbers>

namespace cnc::contour {
namespace {

using std::numbers::pi;

/// An offset with all its storage, on the heap, which only tests may use.
template <typename Scalar, std::size_t kElements = 512, std::size_t kCuts = 4096>
class Bench {
 public:
  using Shape = BoundedContour<Scalar, 2 * kElements, 64>;

  Bench& add(Scalar x, Scalar y, Scalar bulge = 0) {
    EXPECT_TRUE(input_->add({x, y, bulge}));
    return *this;
  }
  Bench& close() {
    EXPECT_TRUE(input_->end_loop());
    return *this;
  }
  Bench& rectangle(Scalar x0, Scalar y0, Scalar x1, Scalar y1) {
    return add(x0, y0).add(x1, y0).add(x1, y1).add(x0, y1).close();
  }
  Bench& circle(Scalar radius, Scalar bulge = 1) {
    return add(radius, 0, bulge).add(-radius, 0, bulge).close();
  }
  Result<ContourView<Scalar>, OffsetError> offset(Scalar distance) {
    return contour::offset<Scalar>(input_->view(), distance, space_->space(), output_->writer());
  }

 private:
  std::unique_ptr<Shape> input_ = std::make_unique<Shape>();
  std::unique_ptr<Shape> output_ = std::make_unique<Shape>();
  std::unique_ptr<BoundedOffsetSpace<Scalar, kElements, kCuts>> space_ =
      std::make_unique<BoundedOffsetSpace<Scalar, kElements, kCuts>>();
};

template <typename Scalar>
double area(const ContourView<Scalar>& contour) {
  double sum = 0.0;
  for (std::size_t loop = 0; loop < contour.loop_ends.size(); ++loop) {
    const std::uint32_t first = contour.loop_begin(loop);
    for (std::uint32_t i = first; i < contour.loop_ends[loop]; ++i) {
      const Vertex<Scalar>& from = contour.vertices[i];
      const Vertex<Scalar>& to = contour.vertices[i + 1 < contour.loop_ends[loop] ? i + 1 : first];
      const double x0 = from.x, y0 = from.y, x1 = to.x, y1 = to.y, b = from.bulge;
      sum += 0.5 * (x0 * y1 - x1 * y0);
      if (b == 0.0) continue;
      const double sweep = 4.0 * std::atan(b);
      const double radius = std::hypot(x1 - x0, y1 - y0) / (2.0 * std::sin(0.5 * std::abs(sweep)));
      sum += 0.5 * radius * radius * (sweep - std::sin(sweep));
    }
  }
  return sum;
}

TEST(Offset, RoundsTheCornersOfASquareThatGrows) {
  Bench<double> bench;
  const auto result = bench.rectangle(0, 0, 10, 10).offset(2.0);
  ASSERT_TRUE(result.ok());
  EXPECT_EQ(result.value().loop_ends.size(), 1U);
  EXPECT_EQ(result.value().vertices.size(), 8U);
  EXPECT_NEAR(area(result.value()), 100.0 + 4.0 * 20.0 + 4.0 * pi, 1e-10);
}

TEST(Offset, KeepsTheCornersOfASquareThatShrinks) {
  Bench<double> bench;
  const auto result = bench.rectangle(0, 0, 10, 10).offset(-2.0);
  ASSERT_TRUE(result.ok());
  EXPECT_EQ(result.value().vertices.size(), 4U);
  EXPECT_NEAR(area(result.value()), 36.0, 1e-12);
}

TEST(Offset, VanishesWhenHalfTheWidthIsUsedUp) {
  for (const double distance : {-5.0, -5.0 - 1e-12, -7.0, -500.0}) {
    Bench<double> bench;
    const auto result = bench.rectangle(0, 0, 10, 30).offset(distance);
    ASSERT_TRUE(result.ok()) << distance;
    EXPECT_EQ(result.value().vertices.size(), 0U) << distance;
  }
}

TEST(Offset, ACircleStaysACircle) {
  for (const double distance : {-9.0, -1.0, 1.0, 100.0}) {
    Bench<double> bench;
    const auto result = bench.circle(10.0).offset(distance);
    ASSERT_TRUE(result.ok());
    EXPECT_EQ(result.value().vertices.size(), 2U);
    EXPECT_NEAR(area(result.value()), pi * (10.0 + distance) * (10.0 + distance), 1e-9);
  }
}

TEST(Offset, ACircleOfItsOwnRadiusVanishes) {
  Bench<double> bench;
  const auto result = bench.circle(10.0).offset(-10.0);
  ASSERT_TRUE(result.ok());
  EXPECT_EQ(result.value().vertices.size(), 0U);
}

TEST(Offset, SplitsAtANeck) {
  Bench<double> bench;
  bench.add(0, 0).add(10, 0).add(10, 4).add(20, 4).add(20, 0).add(30, 0);
  bench.add(30, 10).add(20, 10).add(20, 6).add(10, 6).add(10, 10).add(0, 10).close();
  const auto result = bench.offset(-1.5);
  ASSERT_TRUE(result.ok());
  EXPECT_EQ(result.value().loop_ends.size(), 2U);
}

// At the moment when a neck closes, two arcs end in a tip with an angle of zero, whose sign is a
// rounding error. This tip is not the end of a slot, which would receive half a circle.
TEST(Offset, NothingIsBeyondATipWithoutAnAngle) {
  const double tip = 5.932936430626526;
  const double quarter = std::sqrt(2.0) - 1.0;
  Bench<double> bench;
  bench.add(57.98529288529933, 0, -quarter).add(63.918229315925856, -tip);
  bench.add(63.918229315925856, -30.723990811638796, 0.047906097228552352);
  bench.add(70.750993009198268, -30.723990811638796).add(70.750993009198268, -tip, -quarter);
  bench.add(76.683929439824794, 0, -quarter).add(70.750993009198268, tip);
  bench.add(70.750993009198268, 29.82532862774417).add(63.918229315925856, 29.82532862774417);
  bench.add(63.918229315925856, tip, -quarter).close();
  const auto result = bench.offset(-tip - 1e-7);
  ASSERT_TRUE(result.ok());
  EXPECT_EQ(result.value().loop_ends.size(), 0U);
}

TEST(Offset, ANeckOfTwiceTheDistanceIsClosed) {
  Bench<double> bench;
  bench.add(0, 0).add(10, 0).add(10, 4).add(20, 4).add(20, 0).add(30, 0);
  bench.add(30, 10).add(20, 10).add(20, 6).add(10, 6).add(10, 10).add(0, 10).close();
  const auto result = bench.offset(-1.0);
  ASSERT_TRUE(result.ok());
  EXPECT_EQ(result.value().loop_ends.size(), 2U);
  // Each half is a square of 8 mm. Towards the neck it also has 2 mm × 1 mm, less two quarter
  // circles of 1 mm around the neck's corners.
  EXPECT_NEAR(area(result.value()), 2.0 * (64.0 + 2.0 - pi / 2.0), 1e-9);
}

TEST(Offset, MergesNeighboursAndFillsHolesOfOnePlate) {
  Bench<double> bench;
  bench.rectangle(0, 0, 10, 10).rectangle(11, 0, 21, 10);
  bench.add(4, 4).add(4, 5).add(5, 5).add(5, 4).close();
  const auto result = bench.offset(0.75);
  ASSERT_TRUE(result.ok());
  EXPECT_EQ(result.value().loop_ends.size(), 1U);
}

TEST(Offset, AFilletOfTheDistanceBecomesACorner) {
  Bench<double> bench;
  const double quarter = std::sqrt(2.0) - 1.0;
  bench.add(1, 0).add(9, 0, quarter).add(10, 1).add(10, 9, quarter);
  bench.add(9, 10).add(1, 10, quarter).add(0, 9).add(0, 1, quarter).close();
  const auto result = bench.offset(-1.0);
  ASSERT_TRUE(result.ok());
  EXPECT_EQ(result.value().vertices.size(), 4U);
  EXPECT_NEAR(area(result.value()), 64.0, 1e-12);
}

TEST(Offset, ZeroLengthElementsAndSpikesWithoutWidthCountForNothing) {
  Bench<double> bench;
  bench.add(0, 0).add(0, 0).add(10, 0).add(10, 5).add(15, 5).add(10, 5);
  bench.add(10, 10).add(0, 10).add(0, 10, 0.5).add(0, 10).close();
  const auto result = bench.offset(1.0);
  ASSERT_TRUE(result.ok());
  EXPECT_NEAR(area(result.value()), 140.0 + pi, 1e-9);
}

TEST(Offset, MoreThanHalfATurnIsAllowed) {
  Bench<double> bench;
  bench.add(0, 0, std::tan(0.375 * pi)).add(10, 0).close();
  const auto result = bench.offset(1.0);
  ASSERT_TRUE(result.ok());
  EXPECT_EQ(result.value().loop_ends.size(), 1U);
}

TEST(Offset, NothingMovesByNothing) {
  Bench<double> bench;
  const auto result = bench.rectangle(0, 0, 10, 10).offset(0.0);
  ASSERT_TRUE(result.ok());
  EXPECT_EQ(result.value().vertices.size(), 4U);
}

TEST(Offset, RefusesNumbersThatAreNone) {
  for (const double bad : {std::numeric_limits<double>::infinity(), std::nan("")}) {
    Bench<double> place;
    EXPECT_EQ(place.rectangle(0, 0, bad, 10).offset(1.0).error().fault, OffsetFault::kNotANumber);
    Bench<double> distance;
    EXPECT_EQ(distance.rectangle(0, 0, 1, 1).offset(bad).error().fault, OffsetFault::kNotANumber);
    Bench<double> bulge;
    EXPECT_EQ(bulge.circle(1, bad).offset(1.0).error().fault, OffsetFault::kNotANumber);
  }
}

TEST(Offset, SaysHowManyElementsAreTooMany) {
  Bench<double> bench;
  for (int i = 0; i < 513; ++i) {
    const double angle = 2.0 * pi * i / 513.0;
    bench.add(std::cos(angle), std::sin(angle));
  }
  const auto result = bench.close().offset(0.1);
  ASSERT_FALSE(result.ok());
  EXPECT_EQ(result.error().fault, OffsetFault::kTooManyElements);
  EXPECT_EQ(result.error().elements, 513U);
  EXPECT_EQ(result.error().capacity, 512U);
}

TEST(Offset, SaysWhenMeetingsAreTooMany) {
  Bench<double, 64, 2> bench;
  const auto result = bench.rectangle(0, 0, 10, 10).rectangle(11, 0, 21, 10).offset(2.0);
  ASSERT_FALSE(result.ok());
  EXPECT_EQ(result.error().fault, OffsetFault::kTooManyMeetings);
}

TEST(Offset, SinglePrecisionDoesTheSameWithinItsOwnResolution) {
  Bench<float> bench;
  const float quarter = 0.41421356F;
  bench.add(1, 0).add(9, 0, quarter).add(10, 1).add(10, 9).add(6, 9).add(6, 4);
  const auto result = bench.add(4, 4).add(4, 9).add(0, 9).add(0, 0).close().offset(-1.0F);
  ASSERT_TRUE(result.ok());
  Bench<double> wide;
  wide.add(1, 0).add(9, 0, static_cast<double>(quarter)).add(10, 1).add(10, 9).add(6, 9).add(6, 4);
  const auto expected = wide.add(4, 4).add(4, 9).add(0, 9).add(0, 0).close().offset(-1.0);
  ASSERT_TRUE(expected.ok());
  EXPECT_EQ(result.value().vertices.size(), expected.value().vertices.size());
  EXPECT_NEAR(area(result.value()), area(expected.value()), 1e-3);
}

}  // namespace
}  // namespace cnc::contour
