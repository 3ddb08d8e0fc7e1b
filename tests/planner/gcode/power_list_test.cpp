#include <string>
#include <vector>

#include "tests/planner/gcode/interpreter_test.hpp"

namespace cnc::gcode {
namespace {

class PowerListTest : public InterpreterTest {
 protected:
  PowerListTest() {
    Options options;
    options.laser = true;
    interpreter.set_options(options);
    take("G21 G91 G94 G17 M4 F6000");
  }

  static std::vector<float> powers_of(const Action& action) {
    return {action.powers.begin(), action.powers.end()};
  }
};

TEST_F(PowerListTest, GoesWithTheLineItStandsIn) {
  const auto action = interpreter.interpret("G1Y-0.8S0.875:0:0:0:.5:0:0:1").value()[0];
  EXPECT_EQ(action.kind, ActionKind::kLine);
  EXPECT_EQ(powers_of(action), (std::vector<float>{0.875F, 0, 0, 0, 0.5F, 0, 0, 1}));
  EXPECT_EQ(at(Axis::kY), Coordinate{-800'000});
  EXPECT_FLOAT_EQ(interpreter.state().spindle_speed, 1.0F) << "the last stays";
}

TEST_F(PowerListTest, MayStandAnywhereInTheLineWithBlanksAndWithoutG1) {
  take("G1 X1");
  EXPECT_EQ(powers_of(interpreter.interpret("S 1 : 2 (grey) :3 X4 N7").value()[0]),
            (std::vector<float>{1, 2, 3}));
  EXPECT_TRUE(take_one("X4").powers.empty()) << "it is of its own line";
}

TEST_F(PowerListTest, IsRefusedWhereNothingGoesStraight) {
  for (const char* const line : {"S1:2",
                                 "G1 S1:2",
                                 "G0 X1 S1:2",
                                 "G2 X1 I0.5 S1:2",
                                 "M5 S1:2",
                                 "G5 X1 Y1 I1 J0 P1 Q0 S1:2",
                                 "G4 P1 S1:2"}) {
    const Fault fault = refuse(line);
    EXPECT_EQ(fault.detail, FaultDetail::kPowersNeedLine) << line;
    EXPECT_EQ(fault.code(), ErrorCode::kWordUnused);
    EXPECT_EQ(fault.column, std::string{line}.find('S') + 1) << line;
  }
}

TEST_F(PowerListTest, IsRefusedWithoutALaser) {
  interpreter.set_options({});
  const Fault fault = refuse("G1 X1 S1:2");
  EXPECT_EQ(fault.column, 7);
  EXPECT_EQ(words_of(fault), "S with several values needs laser mode, $32=1");
}

TEST_F(PowerListTest, IsRefusedWithValuesThatSMayNotHave) {
  EXPECT_EQ(refuse("G1 X1 S1:-2").detail, FaultDetail::kNegative);
  EXPECT_EQ(refuse("G1 X1 S1:").detail, FaultDetail::kNumberMissing);
  EXPECT_EQ(refuse("G1 X1 S1::2").column, 9);
  EXPECT_EQ(refuse("G1 X1 S1:2000001").detail, FaultDetail::kTooLarge);
  EXPECT_EQ(refuse("G1 X1:2").detail, FaultDetail::kNotALetter);
  EXPECT_EQ(refuse("G1 X1 S1:2 S3").detail, FaultDetail::kRepeated);
}

TEST_F(PowerListTest, HasAsManyValuesAsItMay) {
  std::string line = "G1 X6.4 S0";
  for (std::size_t i = 1; i < kMaxPowers; ++i) line += ":" + std::to_string(i);
  EXPECT_EQ(take_one(line).powers.size(), kMaxPowers);
  const Fault fault = refuse(line + ":64");
  EXPECT_EQ(words_of(fault), "S has more than 64 values");
  EXPECT_EQ(fault.column, line.size() + 1);
}

TEST_F(PowerListTest, IsNoJog) { EXPECT_FALSE(interpreter.interpret_jog("X1 F100 S1:2").ok()); }

}  // namespace
}  // namespace cnc::gcode
