// Tests leads and motions of other axes, which G41 and G42 receive before and after an outline.
#include <gtest/gtest.h>

#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "planner/compensation/compensator.hpp"

namespace cnc::compensation {
namespace {

constexpr float kQuarter = 0.41421356F;  ///< Bulge of a quarter of a turn.

/// A path 1 mm on the left of a program, with z.
class Path {
 public:
  Path(float x, float y, float offset_mm = -1.0F) {
    here_[0] = from_mm(x);
    here_[1] = from_mm(y);
    compensator.begin(here_, Plane::kXY, offset_mm);
  }

  Path& to(float x, float y, float bulge = 0.0F) {
    end_ = here_;
    here_[0] = from_mm(x);
    here_[1] = from_mm(y);
    return put(bulge);
  }
  Path& lift(float z) {
    end_ = here_;
    here_[2] = from_mm(z);
    return put(0.0F);
  }
  Path& descend_along(float x, float y, float z, float bulge) {
    end_ = here_;
    here_[0] = from_mm(x);
    here_[1] = from_mm(y);
    here_[2] = from_mm(z);
    return put(bulge);
  }
  Path& rapid() {
    feed_ = 0.0F;
    return *this;
  }
  Path& end() {
    if (!fault) fault = compensator.end();
    take();
    return *this;
  }
  [[nodiscard]] Position at(float x, float y) const {
    Position place = here_;
    place[0] = from_mm(x);
    place[1] = from_mm(y);
    return place;
  }
  [[nodiscard]] std::string fault_text() const {
    if (!fault) return "driven";
    return std::to_string(static_cast<int>(fault->reason)) + " of " +
           std::to_string(fault->element) + " and " + std::to_string(fault->other);
  }

  Compensator compensator{};
  std::optional<Fault> fault{};
  std::vector<PathElement> way{};

 private:
  Path& put(float bulge) {
    ++line_;
    if (fault) return *this;
    fault = compensator.put({.request = {.element = {.start = end_, .end = here_, .bulge = bulge},
                                         .feed_mm_s = feed_,
                                         .line = line_}});
    feed_ = 10.0F;
    take();
    return *this;
  }
  void take() {
    path::PathItem item;
    while (!fault && compensator.take(item)) {
      EXPECT_TRUE(way.empty() || way.back().end == item.request.element.start);
      way.push_back(item.request.element);
    }
  }

  Position here_{};
  Position end_{};
  float feed_ = 10.0F;
  std::uint32_t line_ = 0;
};

void expect_place(const Position& place, float x, float y, float z = 0.0F) {
  EXPECT_NEAR(place[0].mm(), x, 2e-5F);
  EXPECT_NEAR(place[1].mm(), y, 2e-5F);
  EXPECT_NEAR(place[2].mm(), z, 2e-5F);
}

/// Appends a rectangle from (0, 15), clockwise, with the tool outside.
Path& rectangle(Path& path) { return path.to(0, 30).to(40, 30).to(40, 0).to(0, 0).to(0, 15); }

TEST(Leads, ArcsInAndOutMayCrossOneAnother) {
  Path path{-10.0F, -5.0F, -3.0F};
  rectangle(path.to(-10, 5).to(0, 15, kQuarter)).to(-10, 25, kQuarter).end();
  ASSERT_FALSE(path.fault) << path.fault_text();
  expect_place(path.way.back().end, -10.0F, 22.0F);
  EXPECT_FALSE(path.compensator.leave(path.at(-20, 25), false));
}

/// Without a closed outline between them, the same elements are not leads.
TEST(Leads, OfAnOpenPathAreEdges) {
  Path path{-10.0F, -5.0F, -3.0F};
  path.to(-10, 5).to(0, 15, kQuarter).to(0, 30).to(40, 30).to(40, 0).to(0, 0).to(0, 14);
  path.to(-10, 24, kQuarter).end();
  ASSERT_TRUE(path.fault);
  EXPECT_EQ(path.fault->reason, Reason::kTooNear);
  EXPECT_TRUE(path.way.empty());
}

TEST(Leads, CutNothingOfTheOutline) {
  // The lead-in arc of 12 mm passes the far wall of a pocket 10 mm wide.
  Path path{-7.0F, 12.0F, -2.0F};
  path.to(-7, 11).to(5, 0, 0.5F).to(5, 10).to(-5, 10).to(-5, -20).to(5, -20).to(5, 0).end();
  ASSERT_TRUE(path.fault);
  EXPECT_TRUE(path.way.empty());
}

/// The lead-out ends above the floor of a recess that the path has passed before.
TEST(Leads, OfALongOutlineAreSeenWhenItCloses) {
  Path path{-20.0F, 12.0F, -3.0F};
  path.to(-10, 5).to(0, 15, kQuarter).to(0, 30);
  for (int i = 1; i <= 20; ++i) path.to(2.0F * static_cast<float>(i), 30);
  path.to(40, -20).to(-20, -20).to(-20, 0).to(0, 0).to(0, 15).to(-7, 15, 1.0F).to(-7, 4).end();
  EXPECT_FALSE(path.fault) << path.fault_text();
}

TEST(Leads, AnArcIsTheEntryMotion) {
  // The path runs from the centre of a bore of 20 mm and back, as nc_files/gmoccapy mills two
  // circles.
  Path path{0.0F, 0.0F, -3.0F};
  path.to(20, 0, 1.0F).to(-20, 0, 1.0F).to(20, 0, 1.0F).to(0, 0, 1.0F).end();
  ASSERT_FALSE(path.fault) << path.fault_text();
  ASSERT_EQ(path.way.size(), 4U);
  expect_place(path.way[0].end, 17.0F, 0.0F);
  EXPECT_NEAR(path.way[0].bulge, 1.0F, 1e-5F);
  expect_place(path.way[3].end, 3.0F, 0.0F);
}

TEST(Leads, AnEntryDoesNotCutTheCornerAtItsEnd) {
  // The entry leads to the corner of a square along its edge.
  Path path{0.0F, -2.0F};
  path.to(0, 0).to(0, 10).to(10, 10).to(10, 0).to(0, 0).end();
  ASSERT_FALSE(path.fault) << path.fault_text();
  expect_place(path.way[0].end, -std::sqrt(0.75F), -0.5F);
  expect_place(path.way[1].end, -1.0F, 0.0F);
  EXPECT_LT(path.way[1].bulge, 0.0F);
}

TEST(Leads, AnExitDoesNotCutTheCornerWhereItBegins) {
  Path path{-4.0F, 5.0F};
  path.to(0, 5).to(0, 10).to(10, 10).to(10, 0).to(0, 0).end();
  ASSERT_FALSE(path.fault) << path.fault_text();
  EXPECT_FALSE(path.compensator.leave(path.at(-2, 0), false));
  path::PathItem turn;
  ASSERT_TRUE(path.compensator.take(turn));
  expect_place(turn.request.element.end, -0.5F, -std::sqrt(0.75F));
  EXPECT_FALSE(path.compensator.take(turn));
}

TEST(Leads, WhatIsDrivenTwiceMayBeRoundedOtherwise) {
  // The path covers the start of a slanted edge once more, rounded to three decimals.
  Path path{-4.0F, 4.0F};
  path.to(0, 1).to(7, 10).to(20, 0).to(-7, -8).to(0, 1).to(0.7F, 1.901F).to(-2, 5).end();
  EXPECT_FALSE(path.fault) << path.fault_text();
}

TEST(Leads, OtherAxesMoveAlong) {
  // The path is a thread: three turns of a helix between quarter arcs, 2 mm inside.
  Path path{0.0F, 0.0F, -2.0F};
  path.to(5, -5).to(10, 0, kQuarter);
  for (int turn = 0; turn < 3; ++turn) {
    const auto z = 1.5F * static_cast<float>(turn);
    path.descend_along(-10, 0, z + 0.75F, 1.0F).descend_along(10, 0, z + 1.5F, 1.0F);
  }
  path.to(5, 5, kQuarter).end();
  ASSERT_FALSE(path.fault) << path.fault_text();
  ASSERT_EQ(path.way.size(), 9U);
  expect_place(path.way[2].end, -8.0F, 0.0F, 0.75F);
  expect_place(path.way[7].end, 8.0F, 0.0F, 4.5F);
  expect_place(path.way[8].end, 5.0F, 3.0F, 4.5F);
}

TEST(Leads, AToolThatOnlyRisesStaysBeside) {
  Path path{-10.0F, 5.0F};
  path.to(0, 5).lift(-1).to(0, 10).lift(2).end();
  ASSERT_FALSE(path.fault) << path.fault_text();
  ASSERT_EQ(path.way.size(), 4U);
  expect_place(path.way[1].end, -1.0F, 6.0F, -1.0F);
  expect_place(path.way[3].end, -1.0F, 10.0F, 2.0F);
}

TEST(Leads, ARapidAboveThePartIsNoCut) {
  for (const bool lifted : {false, true}) {
    Path path{-4.0F, 5.0F};
    rectangle(path.to(0, 15));
    if (lifted) path.rapid().lift(5);
    path.end();
    ASSERT_FALSE(path.fault) << path.fault_text();
    EXPECT_EQ(path.compensator.leave(path.at(20, 20), true).has_value(), !lifted);
  }
}

TEST(Leads, TooManyMotionsThatStandAreRefused) {
  Path path{-10.0F, 5.0F};
  path.to(0, 5);
  for (int i = 0; i < 30; ++i) path.lift(static_cast<float>(i % 2));
  ASSERT_TRUE(path.fault);
  EXPECT_EQ(path.fault->reason, Reason::kOtherAxis);
}

}  // namespace
}  // namespace cnc::compensation
