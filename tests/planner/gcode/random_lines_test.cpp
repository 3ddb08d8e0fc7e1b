#include <random>
#include <string>

#include "tests/planner/gcode/interpreter_test.hpp"
#include "tests/support/trials.hpp"

namespace cnc::gcode {
namespace {

class RandomLines : public InterpreterTest {
 protected:
  /// Checks any line: a refusal must change nothing, and all values must be in range.
  void check(std::string_view line) {
    const Snapshot before{interpreter};
    const auto actions = interpreter.interpret(line);
    if (!actions.ok()) {
      ASSERT_TRUE(Snapshot{interpreter} == before) << "'" << line << "'";
      ASSERT_FALSE(words_of(actions.error()).empty());
      return;
    }
    ++accepted;
    for (const Action& action : actions.value()) {
      for (const Coordinate axis : action.end) ASSERT_TRUE(axis.in_range()) << line;
      for (const Coordinate axis : action.centre) ASSERT_TRUE(axis.in_range()) << line;
      ASSERT_GE(action.feed, 0.0F) << line;
      ASSERT_LT(action.feed, 1.0e20F) << line;
    }
    for (const Coordinate axis : interpreter.position()) ASSERT_TRUE(axis.in_range()) << line;
  }

  int accepted = 0;
};

TEST_F(RandomLines, OfAnyBytes) {
  const auto seed = static_cast<unsigned>(proof::test_seed());
  SCOPED_TRACE(testing::Message() << "KERFLINE_SEED=" << seed);
  std::mt19937 random{seed};
  std::string line;
  for (int trial = 0; trial < 300'000; ++trial) {
    line.resize(random() % 24);
    for (char& c : line) c = static_cast<char>(random() % 256);
    check(line);
    if (HasFatalFailure()) return;
  }
}

// Lines consist of pieces of real lines, so that many of them reach the code for arcs and offsets.
TEST_F(RandomLines, OfPlausibleWords) {
  const auto seed = static_cast<unsigned>(proof::test_seed());
  SCOPED_TRACE(testing::Message() << "KERFLINE_SEED=" << seed);
  std::mt19937 random{seed};
  const char* const pieces[]{
      "G0",  "G1",  "G2",    "G3",    "G4",    "G10",   "G17",   "G18",   "G19",   "G20",
      "G21", "G28", "G28.1", "G30",   "G38.2", "G43.1", "G49",   "G53",   "G54",   "G59.3",
      "G80", "G90", "G91",   "G90.1", "G91.1", "G92",   "G92.1", "G92.2", "G92.3", "G93",
      "G94", "M2",  "M3",    "M8",    "M62",   "M67",   "X",     "Y",     "Z",     "A",
      "C",   "I",   "J",     "K",     "R",     "P",     "L2",    "L20",   "F",     "S",
      "T",   "N",   "E",     "Q",     "(",     ")",     "/",     "%",     "-",     "."};
  const char* const numbers[]{"0",
                              "1",
                              "-1",
                              "2.5",
                              "10",
                              "-0.001",
                              "5",
                              "100",
                              ".5",
                              "9",
                              "1e5",
                              "1000000",
                              "999999999",
                              "10000000",
                              "20",
                              "-20",
                              "3.3",
                              ""};
  std::string line;
  for (unsigned trial = 0; trial < 1'000'000; ++trial) {
    line.clear();
    for (unsigned word = 0; word < 1 + trial % 7; ++word) {
      const std::string_view piece = pieces[random() % std::size(pieces)];
      line += piece;
      if (piece.size() == 1) line += numbers[random() % std::size(numbers)];
    }
    check(line);
    if (HasFatalFailure()) return;
  }
  EXPECT_GT(accepted, 50'000) << "the pieces are not plausible enough";
}

}  // namespace
}  // namespace cnc::gcode
