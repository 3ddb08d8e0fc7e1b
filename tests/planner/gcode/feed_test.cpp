#include <cmath>
#include <numbers>

#include "tests/planner/gcode/interpreter_test.hpp"

namespace cnc::gcode {
namespace {

class Feed : public InterpreterTest {};

TEST_F(Feed, IsMillimetresPerSecondInside) {
  EXPECT_EQ(take_one("G1 X1 F90").feed, 1.5F);
  EXPECT_EQ(take_one("G20 X1").feed, 1.5F);
  EXPECT_EQ(take_one("X2 F60").feed, 25.4F);
  EXPECT_EQ(take_one("G21 X1").feed, 25.4F);
}

TEST_F(Feed, IsDegreesPerSecondWhereOnlyRotaryAxesMove) {
  EXPECT_EQ(take_one("G20 G1 A90 F60").feed, 1.0F);
  EXPECT_EQ(take_one("X1 A180").feed, 25.4F);
  EXPECT_EQ(take_one("X1 A270").feed, 1.0F);
}

TEST_F(Feed, RapidsHaveNone) { EXPECT_EQ(take_one("G0 X1 F600").feed, 0.0F); }

TEST_F(Feed, InverseTimeCoversTheMotionInItsShareOfAMinute) {
  EXPECT_FLOAT_EQ(take_one("G93 G1 X3 Y4 F2").feed, 5.0F * 2.0F / 60.0F);
  EXPECT_FLOAT_EQ(take_one("X3 Y4 A10 B10 F60").feed, std::sqrt(200.0F));
  EXPECT_FLOAT_EQ(take_one("X6 Y8 A20 F60").feed, 5.0F);
}

TEST_F(Feed, InverseTimeCountsTurnsAndRise) {
  const float circle = 20.0F * std::numbers::pi_v<float>;
  EXPECT_FLOAT_EQ(take_one("G93 G2 X0 Y0 I10 F60").feed, circle);
  EXPECT_FLOAT_EQ(take_one("G2 X0 Y0 I10 P3 F60").feed, 3.0F * circle);
  EXPECT_FLOAT_EQ(take_one("G3 X20 Y0 I10 F60").feed, 0.5F * circle);
  EXPECT_FLOAT_EQ(take_one("G3 X10 Y10 I-10 F60").feed, 0.25F * circle);
  EXPECT_FLOAT_EQ(take_one("G2 X20 Y0 J-10 F60").feed, 0.25F * circle);
  EXPECT_FLOAT_EQ(take_one("G2 X10 Y10 I-10 F60").feed, 0.75F * circle);
  EXPECT_FLOAT_EQ(take_one("G2 X10 Y10 Z30 J-10 F60").feed, std::hypot(30.0F, circle));
}

TEST_F(Feed, OfInverseTimeDoesNotOutliveItsLine) {
  static_cast<void>(take("G94 F600"));
  static_cast<void>(take("G93 G1 X1 F10"));
  EXPECT_EQ(interpreter.state().feed, 0.0F);
  EXPECT_EQ(refusal_number("X2"), 22);
  static_cast<void>(take("G94"));
  EXPECT_EQ(refusal_number("X2"), 22);
  EXPECT_EQ(take_one("X2 F60").feed, 1.0F);
}

TEST_F(Feed, OfZeroIsAcceptedButNoMotionIsMadeWithIt) {
  static_cast<void>(take("G1 X1 F60"));
  static_cast<void>(take("F0"));
  EXPECT_EQ(refusal_number("X2"), 22);
}

TEST_F(Feed, LinesOfRapidsNeedNone) {
  static_cast<void>(take("G93"));
  EXPECT_EQ(take_one("G0 X5").kind, ActionKind::kRapid);
}

}  // namespace
}  // namespace cnc::gcode
