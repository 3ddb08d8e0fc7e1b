#include "planner/pipeline/action_elements.hpp"

#include <gtest/gtest.h>

#include <string_view>
#include <vector>

#include "planner/gcode/interpreter.hpp"
#include "tests/planner/motion/motion_test.hpp"

namespace cnc {
namespace {

constexpr float kTolerance = 0.002F;  // Tolerance, mm.

class ActionElementsTest : public testing::Test {
 protected:
  ActionElementsTest() {
    gcode::Options options;
    options.laser = true;
    interpreter.set_options(options);
  }

  /// Returns the last action of the line; its path begins at `from`.
  const gcode::Action& read(std::string_view line) {
    from = interpreter.position();
    const auto actions = interpreter.interpret(line);
    CNC_ASSERT(actions.ok() && !actions.value().empty());
    return actions.value().back();
  }
  /// Returns all elements of such a line. Expects that they join, and begin and end with the
  /// action.
  std::vector<ActionPart> parts_of(std::string_view line) {
    const gcode::Action& action = read(line);
    elements.begin(action, from, kTolerance);
    std::vector<ActionPart> parts;
    while (!elements.done()) {
      std::uint32_t points = 1'000'000;
      EXPECT_TRUE(elements.work(points));
      parts.push_back(elements.next());
      const Position& start = parts.size() == 1 ? from : parts[parts.size() - 2].element.end;
      EXPECT_EQ(parts.back().element.start, start);
    }
    EXPECT_EQ(parts.back().element.end, action.end);
    EXPECT_EQ(parts.back().element.end, interpreter.position());
    return parts;
  }

  gcode::Interpreter interpreter;
  ActionElements elements;
  Position from{};
};

TEST_F(ActionElementsTest, MakeALineOneElement) {
  const auto parts = parts_of("G1 X10 Y-3 F600");
  ASSERT_EQ(parts.size(), 1U);
  EXPECT_EQ(parts[0].element.bulge, 0.0F);
  EXPECT_EQ(parts[0].feed_mm_s, 10.0F);
  EXPECT_EQ(parts[0].index, 0U);
  EXPECT_FALSE(parts[0].continues);
  EXPECT_FALSE(parts[0].power_s);
}

TEST_F(ActionElementsTest, GiveARapidNoFeed) {
  parts_of("G1 X1 F600");
  EXPECT_EQ(parts_of("G0 X10")[0].feed_mm_s, 0.0F);
}

TEST_F(ActionElementsTest, DivideALineIntoEqualPartsWithAPowerEach) {
  parts_of("G1 X1 Y1 F600");
  const auto parts = parts_of("G1 X2 Y1 S0.5:0:0.25");
  ASSERT_EQ(parts.size(), 3U);
  const std::vector<float> powers{0.5F, 0.0F, 0.25F};
  const std::vector<std::int64_t> ends{1'333'333, 1'666'666, 2'000'000};
  for (std::size_t i = 0; i < parts.size(); ++i) {
    EXPECT_EQ(parts[i].power_s, powers[i]);
    EXPECT_EQ(parts[i].element.end[0].nanometres(), ends[i]);
    EXPECT_EQ(parts[i].element.end[1].nanometres(), 1'000'000);
    EXPECT_EQ(parts[i].index, i + 1) << "part 0 is a whole line";
    EXPECT_FALSE(parts[i].continues) << "the power changes between them";
  }
}

// If the caller accepts rows and the line is one, all powers are in one element.
TEST_F(ActionElementsTest, LeaveALineOfManyPowersWhole) {
  parts_of("G1 X1 Y1 F600");
  const gcode::Action& action = read("G1 X2 Y1 S0:1:2:3:4:5:6:7:8:9:10:11:12:13:14:15");
  for (const bool rows : {true, false}) {
    elements.begin(action, from, kTolerance, 1, rows);
    EXPECT_EQ(elements.pixels(), rows ? 16U : 0U);
    EXPECT_EQ(elements.next().row.size(), rows ? 16U : 0U);
    EXPECT_EQ(elements.done(), rows);
  }
  elements.begin(action, from, kTolerance, 1, true);
  const ActionPart row = elements.next();
  EXPECT_EQ(row.element.end, action.end);
  EXPECT_EQ(row.row.back(), 15.0F);
  EXPECT_FALSE(row.power_s);
  elements.begin(action, from, kTolerance, 2, true);
  EXPECT_EQ(elements.pixels(), 0U) << "each part has limits of its own";
  elements.begin(read("G1 X3 S0:1:2"), from, kTolerance, 1, true);
  EXPECT_EQ(elements.pixels(), 0U) << "so few are gathered with more";
}

TEST_F(ActionElementsTest, DivideACircleIntoHalfTurnsOfOneCurve) {
  const auto parts = parts_of("G2 X0 Y0 I5 J0 F600");
  ASSERT_EQ(parts.size(), 2U);
  EXPECT_FALSE(parts[0].continues);
  EXPECT_TRUE(parts[1].continues);
  EXPECT_EQ(parts[1].index, 1U);
  EXPECT_NEAR(parts[0].element.bulge, -1.0F, 1.0e-6F);
  EXPECT_EQ(parts[0].element.end, motion::place({10.0}));
}

TEST_F(ActionElementsTest, TurnASplineIntoArcsOfOneCurve) {
  const auto parts = parts_of("G5 X30 Y0 I10 J20 P-10 Q20 F600");
  ASSERT_GT(parts.size(), 2U);
  for (std::size_t i = 0; i < parts.size(); ++i) {
    EXPECT_EQ(parts[i].continues, i > 0);
    EXPECT_EQ(parts[i].index, i);
    EXPECT_NE(parts[i].element.bulge, 0.0F);
  }
}

// The elements do not depend on how the work is divided. No part exceeds its budget by more than
// documented.
TEST_F(ActionElementsTest, WorkOnASplineBitByBit) {
  const auto whole = parts_of("G5 X30 Y0 I10 J20 P-10 Q20 F600");
  interpreter.set_position({});
  elements.begin(read("G5 X30 Y0 I10 J20 P-10 Q20 F600"), from, kTolerance);
  std::vector<ActionPart> parts;
  int waits = 0;
  while (!elements.done()) {
    std::uint32_t points = 10;
    if (!elements.work(points)) {
      EXPECT_EQ(points, 0U);
      ++waits;
      continue;
    }
    parts.push_back(elements.next());
  }
  EXPECT_GT(waits, 5);
  ASSERT_EQ(parts.size(), whole.size());
  for (std::size_t i = 0; i < parts.size(); ++i) {
    EXPECT_EQ(parts[i].element.end, whole[i].element.end);
    EXPECT_EQ(parts[i].element.bulge, whole[i].element.bulge);
  }
}

TEST_F(ActionElementsTest, ForgetAnActionThatIsNotDrivenToItsEnd) {
  elements.begin(read("G2 X0 Y0 I5 J0 F600"), from, kTolerance);
  static_cast<void>(elements.next());
  EXPECT_TRUE(elements.active());
  elements.clear();
  EXPECT_FALSE(elements.active());
  EXPECT_EQ(parts_of("G1 X5").size(), 1U);
}

TEST_F(ActionElementsTest, AcceptOnlyMotionThatTheActionDetermines) {
  EXPECT_TRUE(ActionElements::accepts(read("G0 X1")));
  EXPECT_TRUE(ActionElements::accepts(read("G1 X2 F600")));
  EXPECT_TRUE(ActionElements::accepts(read("G3 X3 R2")));
  EXPECT_TRUE(ActionElements::accepts(read("G5 X6 I1 J1 P-1 Q1")));
  EXPECT_FALSE(ActionElements::accepts(read("G38.2 X7")));
  EXPECT_FALSE(ActionElements::accepts(read("G4 P1")));
}

}  // namespace
}  // namespace cnc
