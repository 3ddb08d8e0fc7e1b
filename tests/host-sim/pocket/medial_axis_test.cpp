#include "host-sim/pocket/medial_axis.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <string_view>

#include "host-sim/contour/contour_text.hpp"

namespace sim::pocket {
namespace {

/// The medial axis of contours that are given as text.
class Drawn {
 public:
  explicit Drawn(std::string_view text)
      : contour_{contour_from_text(text, "test")},
        area_{contour_.view()},
        axis_{medial_axis(area_)} {}

  [[nodiscard]] const MedialAxis& axis() const { return axis_; }
  [[nodiscard]] const OwnedArea& area() const { return area_; }

  /// Returns the radius of a node, or −1 if there is none.
  [[nodiscard]] double radius_at(double x, double y) const {
    for (const AxisPoint& node : axis_.nodes) {
      if ((node.place - cnc::WideVec2{x, y}).norm() < 1.0e-3) return node.radius;
    }
    return -1.0;
  }

 private:
  Contour contour_;
  OwnedArea area_;
  MedialAxis axis_;
};

constexpr double kNear_mm = 1.0e-3;

TEST(MedialAxis, OfASquareLeadsFromItsCornersToTheMiddle) {
  const Drawn square{"0 0\n10 0\n10 10\n0 10\nclosed\n"};
  EXPECT_EQ(square.axis().nodes.size(), 5U);
  EXPECT_EQ(square.axis().chains.size(), 4U);
  EXPECT_NEAR(square.radius_at(5, 5), 5.0, kNear_mm);
  EXPECT_EQ(square.radius_at(0, 0), 0.0);
  EXPECT_EQ(square.radius_at(10, 0), 0.0);
}

TEST(MedialAxis, OfARectangleHasARidge) {
  const Drawn rectangle{"0 0\n20 0\n20 10\n0 10\nclosed\n"};
  EXPECT_EQ(rectangle.axis().chains.size(), 5U);
  EXPECT_NEAR(rectangle.radius_at(5, 5), 5.0, kNear_mm);
  EXPECT_NEAR(rectangle.radius_at(15, 5), 5.0, kNear_mm);
}

TEST(MedialAxis, BendsInAParabolaAroundACornerThatPointsIn) {
  const Drawn angle{"0 0\n20 0\n20 8\n8 8\n8 20\n0 20\nclosed\n"};
  // The node is as far from (8, 8) as from both sides.
  const double middle = 8.0 * std::sqrt(2.0) / (1.0 + std::sqrt(2.0));
  EXPECT_NEAR(angle.radius_at(middle, middle), middle, kNear_mm);
  EXPECT_EQ(angle.axis().chains.size(), 7U);
  std::size_t on_parabola = 0;
  for (const AxisChain& chain : angle.axis().chains) {
    for (const AxisPoint& point : chain.points) {
      const double x = point.place.x();
      const double y = point.place.y();
      if (x <= middle + kNear_mm || x >= 8.0 || y > middle) continue;
      EXPECT_NEAR(y, std::hypot(x - 8.0, y - 8.0), 2.0 * kNear_mm);
      ++on_parabola;
    }
  }
  EXPECT_GT(on_parabola, 3U);
}

TEST(MedialAxis, OfACircleIsItsMiddle) {
  for (const std::string_view text : {"10 0 1\n-10 0 1\nclosed\n",
                                      "10 0 0.41421356237309503\n0 10 0.41421356237309503\n"
                                      "-10 0 0.41421356237309503\n0 -10 0.41421356237309503\n"}) {
    const Drawn circle{text};
    ASSERT_EQ(circle.axis().nodes.size(), 1U);
    EXPECT_TRUE(circle.axis().chains.empty());
    EXPECT_NEAR(circle.axis().nodes[0].radius, 10.0, kNear_mm);
  }
}

TEST(MedialAxis, OfARingIsACircle) {
  const Drawn ring{"10 0 1\n-10 0 1\nclosed\n3 0 -1\n-3 0 -1\nclosed\n"};
  ASSERT_EQ(ring.axis().chains.size(), 1U);
  const AxisChain& chain = ring.axis().chains[0];
  EXPECT_EQ(chain.from, chain.to);
  double length = 0.0;
  for (std::size_t i = 0; i < chain.points.size(); ++i) {
    EXPECT_NEAR(chain.points[i].place.norm(), 6.5, kNear_mm);
    EXPECT_NEAR(chain.points[i].radius, 3.5, kNear_mm);
    if (i > 0) length += (chain.points[i].place - chain.points[i - 1].place).norm();
  }
  EXPECT_NEAR(length, 2.0 * std::acos(-1.0) * 6.5, 0.01);
}

TEST(MedialAxis, EndsInTheMiddleOfARoundEnd) {
  const Drawn stadium{"0 0\n20 0 1\n20 10\n0 10 1\nclosed\n"};
  EXPECT_EQ(stadium.axis().chains.size(), 1U);
  EXPECT_NEAR(stadium.radius_at(0, 5), 5.0, kNear_mm);
  EXPECT_NEAR(stadium.radius_at(20, 5), 5.0, kNear_mm);
}

TEST(MedialAxis, LeadsIntoABayBetweenTwoCornersOfOneArc) {
  // The bay is round about (20, 23), and open to a channel above it.
  const Drawn block{"0 26\n16 26 2\n24 26\n40 26\n40 36\n0 36\nclosed\n"};
  EXPECT_NEAR(block.radius_at(20, 23), 5.0, kNear_mm);
  // An arc of a third of a turn is one piece: above its middle, only its ends are nearest.
  const Drawn shallow{"0 26\n16 26 0.5773502691896258\n24 26\n40 26\n40 46\n0 46\nclosed\n"};
  EXPECT_NEAR(shallow.radius_at(20, 26 + 4 / std::sqrt(3.0)), 8 / std::sqrt(3.0), kNear_mm);
}

TEST(MedialAxis, HasNoBranchesOfCornersThatAreNearlyStraight) {
  const Drawn bent{"0 0\n10 0.001\n20 0\n20 10\n0 10\nclosed\n"};
  EXPECT_EQ(bent.axis().chains.size(), 5U);
}

TEST(MedialAxis, RefusesContoursThatCross) {
  EXPECT_THROW(Drawn{"0 0\n10 10\n10 0\n0 10\nclosed\n"}, std::runtime_error);
  try {
    const Drawn crossed{"0 0\n10 0\n10 10\n0 10\nclosed\n5 5\n15 5\n15 7\n5 7\nclosed\n"};
    FAIL();
  } catch (const std::runtime_error& error) {
    EXPECT_NE(std::string{error.what()}.find("crosses"), std::string::npos);
  }
}

TEST(MedialAxis, OfNothingIsEmpty) {
  const Contour nothing;
  const OwnedArea area{nothing.view()};
  EXPECT_TRUE(medial_axis(area).nodes.empty());
}

}  // namespace
}  // namespace sim::pocket
