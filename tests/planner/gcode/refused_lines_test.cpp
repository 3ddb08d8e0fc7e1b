#include <set>
#include <string>

#include "tests/planner/gcode/interpreter_test.hpp"

namespace cnc::gcode {
namespace {

struct Refused {
  int number;
  int column;  ///< Column of the fault, from 1.
  std::string line;
  std::string before;  ///< A line that is interpreted first; may be empty.
};

/// The longest accepted line; comments do not count.
const std::string kLongestAccepted = "G1 X1 F1" + std::string(248, ' ');

const Refused kRefused[]{
    // 1: a word begins with a letter.
    {1, 1, "1", ""},
    {1, 1, "-", ""},
    {1, 1, ".5", ""},
    {1, 1, "$H", ""},
    {1, 1, "#1=2", ""},
    {1, 1, "[1]", ""},
    {1, 1, "=", ""},
    {1, 1, ")", ""},
    {1, 4, "G0 *3", ""},
    {1, 6, "G0 X1-2", ""},
    {1, 5, "G0X1-2", ""},
    {1, 8, "G0 X1.2.3", ""},
    {1, 9, "G0 X1(c)0", ""},
    {1, 7, "G0 X1 \x7f", ""},
    {1, 4, "G0 \xef\xbb\xbfX1", ""},
    {1, 6, "G0 X1\xc2\xb5", ""},
    {1, 6, "G0 X1\rY2", ""},
    {1, 6, "G0 X1\nY2", ""},
    {1, 1, "(never closed", ""},
    {1, 4, "G0 (never closed", ""},
    {1, 8, "G0 (one(two) X1", ""},
    {1, 10, "G0 (one) ) X1", ""},
    {1, 4, "G0 /X1", ""},
    {1, 4, "G0 %", ""},
    {1, 1, "% G0 X1", ""},
    {1, 1, "%g21", ""},
    {20, 1, ":1001 sub", ""},
    {20, 1, ":", ""},
    {20, 1, ":-1", ""},
    {1, 4, "G0 :1001", ""},
    {1, 6, "G0 X1'", ""},
    // 2: a number follows the letter.
    {2, 1, "G", ""},
    {2, 1, "GX1", ""},
    {2, 4, "G0 X", ""},
    {2, 4, "G0 XY1", ""},
    {2, 4, "G0 X-", ""},
    {2, 4, "G0 X-.", ""},
    {2, 4, "G0 X.", ""},
    {2, 4, "G0 X--1", ""},
    {2, 4, "G0 X+-1", ""},
    {2, 4, "G0 X#1", ""},
    {2, 4, "G0 X[1+1]", ""},
    {2, 1, "NaN", ""},
    {2, 4, "G0 Xinf", ""},
    {2, 4, "G0 X*2", ""},
    {2, 4, "G0 X1234567890", ""},
    {2, 4, "G0 X123456789012345678901234567890", ""},
    {2, 4, "G0 X-123456789012345678901234567890.5", ""},
    {2, 4, "G0 X(c)1", ""},
    // 4: not negative.
    {4, 1, "F-1", ""},
    {4, 1, "S-0.001", ""},
    {4, 1, "T-1", ""},
    {4, 1, "N-1", ""},
    {4, 4, "G4 P-1", ""},
    {4, 5, "G10 P-1 L2 X0", ""},
    {4, 5, "M62 P-1", ""},
    {4, 5, "M67 E-1 Q0", ""},
    {4, 11, "G2 X10 I5 P-1", ""},
    {4, 5, "G64 P-0.01", ""},
    {4, 5, "G64 P-0.01", "F100 G5 X10 Y0 I2 J0 P-2 Q0"},
    {4, 11, "G64 P0.01 Q-1", ""},
    {4, 11, "G2 X10 I5 P0", "G1 F100"},
    // 11: the line is too long.
    {11, 257, kLongestAccepted + " ", ""},
    {11, 257, "(comment)" + kLongestAccepted + " ; more", ""},
    {11, 257, "(" + std::string(65'534, 'x') + ")", ""},
    {11, 257, std::string(4000, 'G'), ""},
    // 20: not supported.
    {20, 1, "G6", ""},
    {20, 1, "G-1", ""},
    {20, 1, "G15", ""},
    {20, 1, "G33 Z1 K1", ""},
    {20, 1, "G38 X1", ""},
    {20, 1, "G38.1 X1", ""},
    {20, 1, "G38.6 X1", ""},
    {20, 1, "G38.25 X1", ""},
    {20, 1, "G28.2", ""},
    {20, 1, "G30.3", ""},
    {20, 1, "G41.2 D1", ""},
    {20, 1, "G43 H1", ""},
    {20, 1, "G43.2 H1", ""},
    {20, 1, "G49.1", ""},
    {20, 1, "G52 X1", ""},
    {20, 1, "G60", ""},
    {20, 1, "G61.2", ""},
    {23, 1, "G64.1 P0.1", ""},
    {20, 1, "G73 X1 Z1 R1 Q1", ""},
    {20, 1, "G81 X1 Z-1 R1", ""},
    {20, 1, "G90.2", ""},
    {20, 1, "G91.2", ""},
    {20, 1, "G92.4", ""},
    {20, 1, "G95", ""},
    {20, 1, "G96 S100", ""},
    {20, 1, "G98", ""},
    {20, 1, "G100", ""},
    {20, 1, "G999999999", ""},
    {20, 1, "M61 Q1", ""},
    {20, 1, "M10", ""},
    {20, 1, "M48", ""},
    {20, 1, "M66 P0 L0", ""},
    {20, 1, "M98 P1", ""},
    {20, 1, "M100", ""},
    {20, 1, "M-3", ""},
    {20, 1, "O100 sub", ""},
    {20, 1, "O<name> sub", ""},
    {20, 1, "o100 if [#1 gt 2]", ""},
    {20, 1, "O1.5", ""},
    {20, 1, "O-1", ""},
    {20, 1, "O100 G0 X1", ""},
    {20, 4, "N5 O100 call", ""},
    {20, 7, "G0 X1 O5", ""},
    {36, 7, "G0 X1 D1", ""},
    {20, 4, "G1 H1", ""},
    {20, 4, "G1 U1", ""},
    {20, 4, "G1 V1", ""},
    {20, 4, "G1 W1", ""},
    {20, 8, "G10 P1 L3 X0", ""},
    {20, 8, "G10 P1 L-2 X0", ""},
    {20, 11, "G10 L2 P1 R45 X0", ""},
    // 21: two words of one modal group.
    {21, 5, "G17 G18", ""},
    {21, 5, "G20 G21", ""},
    {21, 5, "G90 G91", ""},
    {21, 7, "G90.1 G91.1", ""},
    {21, 5, "G93 G94", ""},
    {21, 5, "G54 G55", ""},
    {21, 5, "G54 G59.3", ""},
    {21, 5, "G40 G40", ""},
    {21, 5, "G61 G61", ""},
    {21, 5, "G61 G64 P1", ""},
    {21, 7, "G61.1 G61", ""},
    {21, 5, "G80 G80", ""},
    {21, 4, "G4 G53 P1", ""},
    {21, 7, "G92.1 G92.2", ""},
    {21, 7, "G28.1 G30.1", ""},
    {21, 4, "M3 M5", ""},
    {21, 4, "M7 M9", ""},
    {21, 4, "M0 M30", ""},
    {21, 5, "M62 M63 P1", ""},
    {21, 5, "M65 M67 P1 E1 Q1", ""},
    // 22: feed undefined.
    {22, 1, "G1 X1", ""},
    {22, 1, "G1", ""},
    {22, 1, "G2 X1 I1", ""},
    {22, 1, "G3 X1 R1", ""},
    {22, 1, "G38.2 Z-1", ""},
    {22, 1, "G1 X1 F0", ""},
    {22, 1, "G1 X1 F0.0000000001", ""},
    {22, 1, "X1", "G93 G1 X0 F1"},
    {22, 1, "G1 X1", "G93 F10"},
    {22, 5, "G94 X1", "G93 G1 X0 F10"},
    {22, 5, "G93 G1 X1", "F100"},
    {22, 5, "G93 G38.2 Z-1", "F100"},
    {22, 8, "G93 F0 G1 X1", ""},
    // 23: whole numbers.
    {23, 1, "G1.5", ""},
    {23, 1, "G0.1 X1", ""},
    {23, 1, "G17.1", ""},
    {23, 1, "G54.1", ""},
    {23, 1, "G10.1", ""},
    {23, 1, "G1.001", ""},
    {23, 1, "M3.1", ""},
    {23, 1, "M6.1", ""},
    {23, 1, "T1.5", ""},
    {23, 1, "N1.5 G0", ""},
    {23, 5, "G10 L2.5 P1 X0", ""},
    {23, 8, "G10 L2 P1.5 X0", ""},
    {23, 5, "M62 P0.5", ""},
    {23, 5, "M67 E0.5 Q1", ""},
    {23, 11, "G2 X10 I5 P1.5", "G1 F100"},
    // 24: two words that both require the axis words.
    {24, 4, "G0 G1 X1", ""},
    {24, 4, "G1 G2 X1 R5", ""},
    {24, 4, "G0 G28 X1", ""},
    {24, 5, "G28 G1 X1", ""},
    {24, 5, "G28 G30", ""},
    {24, 5, "G10 G0 L2 P1 X0", ""},
    {24, 4, "G1 G92 X0", ""},
    {24, 4, "G0 G43.1 Z1", ""},
    {24, 8, "G49 G0 G92 X1", ""},
    {24, 8, "G80 G0 G1 X1", ""},
    {24, 5, "G92 G43.1 Z1", ""},
    // 25: a letter twice.
    {25, 7, "G0 X1 X2", ""},
    {25, 4, "F1 F1", ""},
    {25, 8, "G64 P1 P2", ""},
    {25, 4, "S1 S2", ""},
    {25, 4, "T1 T2", ""},
    {25, 4, "N1 N2", ""},
    {25, 10, "G2 X1 I1 I1", ""},
    {25, 10, "G0 X1 Y2 x3", ""},
    // 26: axis words missing.
    {26, 1, "G2 K5", "F100"},
    {26, 1, "G3 R5", "F100"},
    {26, 1, "G38.3", "F100"},
    {26, 1, "G10 L2 P1", ""},
    {26, 1, "G10 L20 P1", ""},
    {26, 1, "G92", ""},
    // 27: line number.
    {27, 1, "N10000000 G0", ""},
    {27, 4, "G0 N999999999", ""},
    // 28: a value word is missing.
    {28, 1, "G4", ""},
    {28, 1, "G4 X1", ""},
    {28, 1, "G10 L2 X0", ""},
    {28, 1, "G10 P1 X0", ""},
    {28, 1, "G10 X0", ""},
    {28, 1, "G41 D1", ""},
    {28, 1, "G42", ""},
    {28, 1, "M62", ""},
    {28, 1, "M65 E1", ""},
    {28, 1, "M67 Q1", ""},
    {28, 1, "M68 E1", ""},
    {28, 8, "M62 P1 G4 X1", "G0"},
    // 29: coordinate systems.
    {29, 1, "G59.4", ""},
    {29, 1, "G59.9 X1", ""},
    {29, 8, "G10 L2 P10 X0", ""},
    {29, 9, "G10 L20 P255 X0", ""},
    // 30: G53 with G0 and G1 only.
    {30, 1, "G53 X1", "G80"},
    {30, 4, "G2 G53 X1 R5", "F100"},
    {30, 1, "G53 G80", ""},
    {30, 1, "G53 X1 R5", "G2 X1 R5 F100"},
    {30, 1, "G53 G38.2 Z-1", "F100"},
    // 31: axis words that no other word uses.
    {31, 1, "X1", "G80"},
    {31, 5, "G80 X1", ""},
    {31, 5, "G21 Y1 X1", "G80"},
    {31, 7, "G92.1 X1", "G80"},
    {31, 11, "G10 L1 P1 X0", ""},
    {31, 5, "G49 C1", "G80"},
    // 32: no axis word in the plane of the arc.
    {32, 1, "G2 Z1 K5", "F100"},
    {32, 1, "G3 A1 R5", "F100"},
    {32, 1, "G3 A1 R5 I1", "F100"},
    {32, 5, "G18 G2 Y1 J5", "F100"},
    {32, 5, "G19 G2 X1 I5", "F100"},
    {32, 1, "Z1", "G2 X0 Y0 I5 F100"},
    // 33: impossible targets.
    {33, 4, "G0 X1000000.000001", ""},
    {33, 4, "G0 X-999999999", ""},
    {33, 7, "G0 X1 Y999999999", ""},
    {33, 4, "G0 A10000000", ""},
    {33, 4, "G0 C-1000000.0000006", ""},
    {33, 8, "G20 G0 X39370.1", ""},
    {33, 8, "G91 G0 X1", "G0 X1000000"},
    {33, 1, "X1", "G0 G91 X1000000"},
    {33, 8, "G53 G0 X1000001", ""},
    {33, 1, "X1", "G10 L2 P1 X1000000"},
    {33, 11, "G10 L2 P1 X1000001", ""},
    {33, 12, "G10 L20 P1 X-1000001", ""},
    {33, 5, "G92 X-1000001", ""},
    {33, 7, "G43.1 Z2000000", ""},
    {33, 5, "G28 X1000001", ""},
    {33, 8, "G2 X10 I10000000", "F100"},
    {33, 12, "G2 X10 Y10 J10000000", "F100"},
    {33, 12, "G2 X10 Y10 J-999999999", "F100"},
    {33, 14, "G90.1 G2 X10 I999999999 J0", "F100"},
    {33, 8, "G2 X10 I0 J0", "F100"},
    {33, 14, "G90.1 G2 X10 I0 J0", "F100"},
    {33, 8, "G2 X10 I5.1", "F100"},
    {33, 8, "G2 X10 I4", "F100"},
    {33, 11, "G2 X10 Y0 J5", "F100"},
    {33, 8, "G2 X10 I5", "G1 X1 Y1 F100"},
    {33, 10, "G2 X0 Y0 R5", "F100"},
    {33, 13, "G2 X0 Y0 Z1 R5", "F100"},
    {33, 1, "G38.2 X0", "F100"},
    {33, 1, "G38.5 X0 Y0 Z0", "F100"},
    {33, 7, "G38.2 Z-2000000", "F100"},
    // 34: impossible radii.
    {34, 8, "G2 X10 R0", "F100"},
    {34, 8, "G2 X10 R4", "F100"},
    {34, 8, "G3 X10 R-4.9", "F100"},
    {34, 8, "G2 X10 R1000001", "F100"},
    {34, 8, "G2 X10 R-999999999", "F100"},
    // 35: no centre.
    {35, 1, "G2 X10", "F100"},
    {35, 1, "G2 X10 K5", "F100"},
    {35, 5, "G18 G3 X10 J5", "F100"},
    {35, 1, "X10", "G2 X0 Y0 I5 F100"},
    {35, 7, "G90.1 G2 X10 I5", "F100"},
    {35, 7, "G90.1 G2 X10 J5", "F100"},
    // 36: values that no other word uses.
    {36, 7, "G0 X1 P1", ""},
    {36, 4, "G0 R1", ""},
    {36, 5, "G61 P0.1", ""},
    {36, 7, "G61.1 Q0.1", ""},
    {36, 10, "G64 P0.1 R1", ""},
    {36, 1, "I1", ""},
    {36, 1, "L2", ""},
    {36, 1, "P1", ""},
    {36, 1, "E1", ""},
    {36, 1, "Q1", ""},
    {36, 4, "X1 I1", "G1 F100"},
    {36, 6, "G0 X1e5", ""},
    {36, 11, "G2 X10 R5 K1", "F100"},
    {36, 1, "K1", "G2 X0 Y0 I5 F100"},
    {36, 5, "G40 I5", "G1 F100"},
    {36, 8, "G2 X10 I5 R5", "F100"},
    {36, 8, "G2 X10 J5 I5 R5", "F100"},
    {36, 4, "G4 R1 P1", ""},
    {36, 15, "G10 L20 P1 X0 R1", ""},
    {36, 5, "G28 P1", ""},
    {36, 1, "R5", "G2 X0 Y0 I5 F100"},
    {36, 11, "M67 E1 Q2 P1", ""},
    // 37: the axis of the tool length.
    {37, 1, "G43.1", ""},
    {37, 7, "G43.1 X1", ""},
    {37, 10, "G43.1 Z1 Y1", ""},
    {37, 10, "G43.1 Z1 A1", ""},
    // 38: more than the greatest value.
    {38, 1, "T256", ""},
    {38, 1, "S1000001", ""},
    {38, 4, "G4 P86401", ""},
    {38, 5, "M62 P8", ""},
    {38, 5, "G64 P10.001", ""},
    {38, 8, "G64 P0 Q11", ""},
    {38, 9, "G20 G64 P0.4", ""},
    {38, 5, "M68 E4 Q1", ""},
    {38, 11, "G2 X10 I5 P65536", "F100"},
    {38, 7, "G1 Y1 F.0000001", "G93 G1 X1 F1"},
    {38, 7, "G1 X1 F0.000002", ""},
    {38, 0, "G1 X1000", "G1 F0.01"},
    {38, 0, "G2 I1 P65535", "G1 F.1"},
    {38, 0, "I1 P65535", "G2 X0 Y0 I1 F.1"},
    {38, 11, "G38.2 Z-1 F0.00001", ""},
    {38, 26, "G5 X10 Y0 I2 J0 P-2 Q0   F.0001", ""},
};

class RefusedLines : public InterpreterTest {};

TEST_F(RefusedLines, HaveTheirNumberAndColumnAndChangeNothing) {
  for (const Refused& refused : kRefused) {
    interpreter = Interpreter{};
    if (!refused.before.empty()) static_cast<void>(take(refused.before));
    const Fault fault = refuse(refused.line);
    EXPECT_EQ(static_cast<int>(fault.code()), refused.number) << refused.line;
    EXPECT_EQ(fault.column, refused.column) << refused.line << ": " << words_of(fault);
  }
}

TEST_F(RefusedLines, NameWhatIsNotSupported) {
  const auto detail = [this](const char* line) { return refuse(line).detail; };
  for (const char* line : {"O100 sub", "o<box> call [1]", "O100 while [#1 lt 2]", "N1 O5 endsub"}) {
    EXPECT_EQ(detail(line), FaultDetail::kOWord) << line;
  }
  for (const char* line : {"#1=2", "[1]", "<a>=1", "G0 X1 #2"}) {
    EXPECT_EQ(detail(line), FaultDetail::kExpression) << line;
  }
  for (const char* line : {"G0 X[1+1]", "G0 X#1", "G1 F #<feed>", "N10 G1 X[2*5]"}) {
    EXPECT_EQ(detail(line), FaultDetail::kExpressionForNumber) << line;
  }
  EXPECT_EQ(detail("G0 XY1"), FaultDetail::kNumberMissing);
}

TEST_F(RefusedLines, CoverEveryNumber) {
  std::set<int> numbers;
  for (const Refused& refused : kRefused) numbers.insert(refused.number);
  const std::set<int> all{1,  2,  4,  11, 20, 21, 22, 23, 24, 25, 26, 27,
                          28, 29, 30, 31, 32, 33, 34, 35, 36, 37, 38};
  EXPECT_EQ(numbers, all);
}

// A line that is refused at its last word contains words for modes, feed, speed, coolant and motion
// before it.
TEST_F(RefusedLines, LeaveNothingOfWhatCameBeforeTheFault) {
  static_cast<void>(refuse("N7 G20 G91 G18 F500 S100 T3 M3 M8 G1 X1 Y2 Z3 A4 L9"));
  static_cast<void>(refuse("G55 G28.1 L9"));
  static_cast<void>(refuse("G10 L2 P2 X5 I1"));
  static_cast<void>(refuse("G92 X5 I1"));
  static_cast<void>(refuse("M30 I1"));
}

}  // namespace
}  // namespace cnc::gcode
