#include <cstdio>
#include <random>

#include "tests/planner/gcode/interpreter_test.hpp"
#include "tests/support/trials.hpp"

namespace cnc::gcode {
namespace {

class Exactness : public InterpreterTest {};

std::string decimal(std::int64_t thousandths) {
  char text[32];
  const auto magnitude = static_cast<long long>(std::abs(thousandths));
  std::snprintf(text,
                sizeof text,
                "%s%lld.%03lld",
                thousandths < 0 ? "-" : "",
                magnitude / 1000,
                magnitude % 1000);
  return text;
}

TEST_F(Exactness, AMillionIncrementsEndWhereIntegersDo) {
  const auto seed = static_cast<unsigned>(proof::test_seed());
  SCOPED_TRACE(testing::Message() << "KERFLINE_SEED=" << seed);
  std::mt19937 random{seed};
  std::uniform_int_distribution<std::int64_t> step{-99'999, 99'999};
  static_cast<void>(take("G91 G1 F100"));
  std::int64_t sum = 0;
  for (int line = 0; line < 1'000'000; ++line) {
    const std::int64_t thousandths = step(random);
    if (std::abs(sum + thousandths) > 900'000'000) continue;
    sum += thousandths;
    ASSERT_TRUE(interpreter.interpret("X" + decimal(thousandths)).ok());
  }
  EXPECT_EQ(at(Axis::kX).nanometres(), sum * 1000);
  ASSERT_TRUE(interpreter.interpret("X" + decimal(-sum)).ok());
  EXPECT_EQ(at(Axis::kX), Coordinate{});
}

TEST_F(Exactness, OffsetsOfAllKindsAddUpAndComeOffAgain) {
  const auto seed = static_cast<unsigned>(proof::test_seed());
  SCOPED_TRACE(testing::Message() << "KERFLINE_SEED=" << seed);
  std::mt19937 random{seed};
  std::uniform_int_distribution<std::int64_t> place{-999'999, 999'999};
  for (int trial = 0; trial < 10'000; ++trial) {
    const std::int64_t origin = place(random);
    const std::int64_t g92 = place(random);
    const std::int64_t tool = place(random);
    const std::int64_t target = place(random);
    static_cast<void>(take("G92.1"));
    static_cast<void>(take("G49"));
    static_cast<void>(take("G10 L2 P1 Z" + decimal(origin)));
    static_cast<void>(take("G0 Z0"));
    static_cast<void>(take("G92 Z" + decimal(g92)));
    static_cast<void>(take("G43.1 Z" + decimal(tool)));
    static_cast<void>(take("G0 Z" + decimal(target)));
    ASSERT_EQ(at(Axis::kZ).nanometres(), (origin - g92 + tool + target) * 1000);
  }
}

TEST_F(Exactness, InchesAddUpWithoutDrift) {
  static_cast<void>(take("G20 G91"));
  for (int line = 0; line < 100'000; ++line) ASSERT_TRUE(interpreter.interpret("X.00001").ok());
  EXPECT_EQ(at(Axis::kX), Coordinate{25'400'000});
}

}  // namespace
}  // namespace cnc::gcode
