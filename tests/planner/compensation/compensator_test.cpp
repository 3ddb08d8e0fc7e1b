#include "planner/compensation/compensator.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace cnc::compensation {
namespace {

/// An entry of 10 mm along y ends at the origin. This is the point at which it touches the circle
/// of 1 mm around its end, on the right.
constexpr float kTouchX = 0.994987F;
constexpr float kTouchY = -0.1F;

/// A program on one side, and the compensated elements.
class Bench {
 public:
  explicit Bench(float offset_mm, float x = 0.0F, float y = 0.0F, Plane plane = Plane::kXY) {
    here_[axes_of(plane).first] = from_mm(x);
    here_[axes_of(plane).second] = from_mm(y);
    plane_ = plane;
    compensator_.begin(here_, plane, offset_mm);
  }

  Bench& to(float x, float y, float bulge = 0.0F) {
    Position end = here_;
    end[axes_of(plane_).first] = from_mm(x);
    end[axes_of(plane_).second] = from_mm(y);
    return put({.start = here_, .end = end, .plane = plane_, .bulge = bulge});
  }
  Bench& put(const PathElement& element) {
    if (fault) return *this;
    ++line_;
    fault = compensator_.put({.request = {.element = element, .feed_mm_s = 10.0F, .line = line_}});
    here_ = element.end;
    drain();
    return *this;
  }
  Bench& end() {
    if (!fault) fault = compensator_.end();
    if (!fault) drain();
    return *this;
  }
  void drain() {
    path::PathItem item;
    while (compensator_.take(item)) {
      if (!given.empty()) {
        EXPECT_EQ(given.back().request.element.end, item.request.element.start);
      }
      given.push_back(item);
    }
  }
  void expect_ends(const std::vector<Vec2>& places) const {
    ASSERT_FALSE(fault) << "reason " << static_cast<int>(fault->reason);
    ASSERT_EQ(given.size(), places.size());
    for (std::size_t i = 0; i < places.size(); ++i) {
      const Position& end = given[i].request.element.end;
      EXPECT_NEAR(end[axes_of(plane_).first].mm(), places[i].x(), 2e-5F) << i;
      EXPECT_NEAR(end[axes_of(plane_).second].mm(), places[i].y(), 2e-5F) << i;
    }
  }
  void expect_fault(Reason reason, std::uint32_t element) const {
    ASSERT_TRUE(fault);
    EXPECT_EQ(static_cast<int>(fault->reason), static_cast<int>(reason));
    EXPECT_EQ(fault->element, element);
    EXPECT_EQ(fault->line, element);
  }
  Position at(float x, float y) const {
    Position place = here_;
    place[0] = from_mm(x);
    place[1] = from_mm(y);
    return place;
  }

  std::optional<Fault> fault{};
  std::vector<path::PathItem> given{};
  Compensator& compensator() { return compensator_; }
  const Position& here() const { return here_; }

 private:
  Compensator compensator_{};
  Position here_{};
  Plane plane_ = Plane::kXY;
  std::uint32_t line_ = 0;
};

TEST(Compensator, GoesRoundASquareOnItsOutside) {
  // The path is clockwise, with the tool on its left.
  Bench bench{-1.0F, -10.0F, 0.0F};
  bench.to(0, 0).to(0, 10).to(10, 10).to(10, 0).to(0, 0).end();
  bench.expect_ends({{-1, 1}, {-1, 10}, {0, 11}, {10, 11}, {11, 10}, {11, 0}, {10, -1}, {0, -1}});
}

TEST(Compensator, TurnsIntoAnInnerCornerWhereBothOffsetsMeet) {
  Bench bench{-1.0F, 0.0F, -10.0F};
  bench.to(0, 0).to(0, 10).to(-10, 10).end();
  bench.expect_ends({{-kTouchX, kTouchY}, {-1, 0}, {-1, 9}, {-10, 9}});
}

TEST(Compensator, OuterCornersAreArcsAboutTheCorner) {
  Bench bench{1.0F, 0.0F, -10.0F};
  bench.to(0, 0).to(0, 10).to(-10, 10).end();
  bench.expect_ends({{kTouchX, kTouchY}, {1, 0}, {1, 10}, {0, 11}, {-10, 11}});
  EXPECT_NEAR(bench.given[3].request.element.bulge, std::tan(std::acos(-1.0F) / 8.0F), 1e-6F);
  EXPECT_EQ(bench.given[3].request.line, 2U);
}

TEST(Compensator, ArcsStayArcs) {
  Bench bench{1.0F, 0.0F, -10.0F};
  bench.to(0, 0).to(-10, 0, 1.0F).end();
  bench.expect_ends({{kTouchX, kTouchY}, {1, 0}, {-11, 0}});
  EXPECT_NEAR(bench.given[2].request.element.bulge, 1.0F, 1e-6F);
}

TEST(Compensator, WorksInEachPlane) {
  for (const Plane plane : {Plane::kXY, Plane::kZX, Plane::kYZ}) {
    Bench bench{1.0F, 0.0F, -10.0F, plane};
    bench.to(0, 0).to(-10, 0, 1.0F).to(-10, -20).end();
    bench.expect_ends({{kTouchX, kTouchY}, {1, 0}, {-11, 0}, {-11, -20}});
  }
}

TEST(Compensator, HoldsElementsUntilSixteenAfterThemAreKnown) {
  Bench bench{1.0F};
  for (int i = 1; i <= 16; ++i) bench.to(0.0F, 10.0F * static_cast<float>(i));
  EXPECT_TRUE(bench.given.empty());
  bench.to(0.0F, 170.0F);
  EXPECT_EQ(bench.given.size(), 2U) << "the entry goes round its end";
  bench.to(0.0F, 180.0F);
  EXPECT_EQ(bench.given.size(), 3U);
  bench.end();
  EXPECT_EQ(bench.given.size(), 19U);
  EXPECT_TRUE(bench.compensator().empty());
}

TEST(Compensator, SwallowsShortElementsAtAnInnerCorner) {
  Bench bench{-1.0F, 0.0F, -10.0F};
  bench.to(0, 0).to(0, 9.9F).to(0, 9.95F).to(0, 10).to(-0.05F, 10).to(-0.2F, 10).to(-10, 10).end();
  bench.expect_ends({{-kTouchX, kTouchY}, {-1, 0}, {-1, 9}, {-10, 9}});
}

TEST(Compensator, RefusesAnEntryThatIsNoneBeforeAnythingMoves) {
  Bench brief{1.0F, 0.0F, -1.0F};
  brief.to(0, 0).expect_fault(Reason::kEntryTooShort, 1);
  EXPECT_TRUE(brief.given.empty());
  Bench narrow{-1.0F, 1.8F, 0.0F};
  narrow.to(0, 0, 1.0F).to(0, -10).end();
  narrow.expect_fault(Reason::kUnreachable, 1);
  EXPECT_TRUE(narrow.given.empty());
}

TEST(Compensator, RefusesAnArcInAnotherPlane) {
  Bench bench{1.0F, 0.0F, -10.0F};
  bench.to(0, 0);
  PathElement arc{.start = bench.here(), .end = bench.here(), .plane = Plane::kYZ, .bulge = 1.0F};
  arc.end[2] = from_mm(-1.0F);
  bench.put(arc).expect_fault(Reason::kOtherAxis, 2);
}

TEST(Compensator, RefusesAnArcNarrowerThanTheOffset) {
  Bench bench{-1.0F, 0.0F, -10.0F};
  bench.to(0, 0).to(0, 10).to(-1.8F, 10, 1.0F).to(-1.8F, 0).end();
  ASSERT_TRUE(bench.fault);
  EXPECT_TRUE(bench.given.empty());
}

TEST(Compensator, RefusesASlotNarrowerThanTwiceTheOffset) {
  Bench bench{-1.0F, -10.0F, 0.0F};
  // The path enters a slot of 1.9 mm and leaves it, inside of the slot.
  bench.to(0, 0).to(10, 0).to(10, -10).to(11.9F, -10).to(11.9F, 0).to(30, 0).end();
  ASSERT_TRUE(bench.fault);
  EXPECT_TRUE(bench.given.empty());
}

TEST(Compensator, RefusesALaterElementThatComesTooNear) {
  Bench bench{-1.0F, -10.0F, 0.0F};
  bench.to(0, 0).to(30, 0).to(30, 10).to(20, 10).to(20, 1.5F).to(19, 1.5F).to(19, 20).end();
  ASSERT_TRUE(bench.fault);
  EXPECT_TRUE(bench.given.empty());
}

TEST(Compensator, RefusesAnExitThroughThePart) {
  Bench bench{1.0F, 0.0F, -10.0F};
  bench.to(0, 0).to(0, 10).end();
  ASSERT_FALSE(bench.fault);
  EXPECT_TRUE(bench.compensator().beside());
  EXPECT_FALSE(bench.compensator().leave(bench.at(5, 20), false));
  EXPECT_FALSE(bench.compensator().beside());
  Bench through{1.0F, 0.0F, -10.0F};
  through.to(0, 0).to(0, 10).end();
  const auto fault = through.compensator().leave(through.at(-5, 5), false);
  ASSERT_TRUE(fault);
  EXPECT_EQ(fault->other, 2U);
}

// In floats, both ends of a short element are one point if the origin is metres away.
TEST(Compensator, TakesElementsOfANanometreFarFromTheOthers) {
  for (const std::int64_t nanometres : {1, 3, 20, 100}) {
    for (const float bulge : {0.0F, 0.5F, -1.0F}) {
      Bench bench{-0.5F, -10.0F, 0.0F};
      bench.to(0, 0).to(9000, 0);
      Position end = bench.here();
      end[1] += Coordinate{nanometres};
      bench.put({.start = bench.here(), .end = end, .bulge = bulge});
      bench.to(9000, 9000).to(-7000, 9000).end();
      if (bulge == 0.0F) {
        EXPECT_FALSE(bench.fault) << nanometres;
      }
      for (const path::PathItem& item : bench.given) {
        EXPECT_TRUE(std::isfinite(item.request.element.bulge));
        EXPECT_LE(std::abs(item.request.element.end[0].mm()), 9000.6F);
        EXPECT_LE(std::abs(item.request.element.end[1].mm()), 9000.6F);
      }
    }
  }
}

}  // namespace
}  // namespace cnc::compensation
