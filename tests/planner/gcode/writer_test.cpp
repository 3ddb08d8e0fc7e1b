#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <string>

#include "planner/gcode/arc_geometry.hpp"
#include "planner/gcode/program_writer.hpp"
#include "tests/planner/gcode/interpreter_test.hpp"
#include "tests/support/random_source.hpp"
#include "tests/support/trials.hpp"

namespace cnc::gcode {
namespace {

using Place = BasicVec2<double>;

std::string text_of(const Result<std::string_view, WriterError>& written) {
  if (!written.ok()) return "refused";
  return std::string{written.value()};
}

ProgramWriter at(double x, double y, std::uint8_t decimals = 3) {
  ProgramWriter writer{PrintGrid{decimals}};
  EXPECT_TRUE(writer.rapid(Place{x, y}).ok());
  return writer;
}

TEST(ProgramWriter, LeavesOutWhatDoesNotChange) {
  ProgramWriter writer{PrintGrid{3}};
  writer.set_feed(1'200'000);
  writer.set_power(800'500);
  EXPECT_EQ(text_of(writer.rapid(Place{1.0, -0.25})), "G0X1Y-0.25\n");
  EXPECT_EQ(text_of(writer.cut(Place{1.0, -0.25}, Place{3.0, -0.25}, 0.0)), "G1X3F1200S800.5\n");
  EXPECT_EQ(text_of(writer.cut(Place{3.0, -0.25}, Place{3.0, 0.0005}, 0.0)), "Y0.001\n");
  EXPECT_EQ(text_of(writer.cut(Place{3.0, 0.001}, Place{3.0, 0.0014}, 0.0)), "");
  EXPECT_EQ(text_of(writer.cut(Place{3.0, 0.001}, Place{7.0, 0.001}, 1.0)), "G3X7I2\n");
  EXPECT_EQ(text_of(writer.cut(Place{7.0, 0.001}, Place{7.0, 4.001}, 1.0)), "Y4.001J2\n");
  EXPECT_EQ(text_of(writer.rapid(Place{7.0, 4.001})), "");
  EXPECT_EQ(text_of(writer.cut(Place{7.0, 4.001}, Place{6.0, 4.001}, 0.0)), "G1X6\n");
}

TEST(ProgramWriter, SplitsWhatIsMoreThanHalfATurn) {
  ProgramWriter writer = at(10.0, 0.0);
  const double three_quarters = std::tan(1.5 * std::numbers::pi / 4.0);
  EXPECT_EQ(text_of(writer.cut(Place{10.0, 0.0}, Place{0.0, -10.0}, three_quarters)),
            "G3X-7.071Y7.071I-10F0S0\nX0Y-10I7.071J-7.071\n");
}

TEST(ProgramWriter, MakesLinesOfWhatBendsLessThanADigit) {
  ProgramWriter writer = at(0.0, 0.0);
  EXPECT_EQ(text_of(writer.cut(Place{0.0, 0.0}, Place{1.0, 0.0}, 0.0004)), "G1X1F0S0\n");
  EXPECT_EQ(text_of(writer.cut(Place{1.0, 0.0}, Place{1.0, 0.0014}, 1.0)), "X1.001Y0.001\nX1\n");
}

TEST(ProgramWriter, RefusesWhatDoesNotFitAndWritesNothing) {
  ProgramWriter writer = at(0.0, 0.0, 5);
  const double nan = std::nan("");
  EXPECT_EQ(text_of(writer.rapid(Place{5000.1, 0.0})), "refused");
  EXPECT_EQ(text_of(writer.rapid(Place{nan, 0.0})), "refused");
  EXPECT_EQ(text_of(writer.cut(Place{0.0, 0.0}, Place{1.0, 0.0}, nan)), "refused");
  const auto flat = writer.cut(Place{0.0, 0.0}, Place{1000.0, 0.0}, 0.001);
  ASSERT_FALSE(flat.ok());
  EXPECT_EQ(flat.error(), WriterError::kTooFlat);
  EXPECT_EQ(text_of(writer.cut(Place{0.0, 0.0}, Place{1.0, 0.0}, 0.0)), "G1X1F0S0\n");
}

TEST(ProgramWriter, ChangesTheHeightAlongMotions) {
  ProgramWriter writer{PrintGrid{3}};
  writer.leave_power();
  writer.set_feed(300'000);
  EXPECT_TRUE(writer.set_height(5.0));
  EXPECT_EQ(text_of(writer.rapid(Place{1.0, 2.0})), "G0Z5\nX1Y2\n");
  EXPECT_TRUE(writer.set_height(0.5));
  EXPECT_EQ(text_of(writer.rapid(Place{1.0, 2.0})), "Z0.5\n");
  EXPECT_TRUE(writer.set_height(-2.0));
  EXPECT_EQ(text_of(writer.cut(Place{1.0, 2.0}, Place{1.0, 2.0}, 0.0)), "G1Z-2F300\n");
  EXPECT_EQ(text_of(writer.cut(Place{1.0, 2.0}, Place{3.0, 2.0}, 0.0)), "X3\n");
  EXPECT_TRUE(writer.set_height(-3.0));
  EXPECT_EQ(text_of(writer.cut(Place{3.0, 2.0}, Place{5.0, 2.0}, 1.0)), "G3X5Z-3I1\n");
  EXPECT_TRUE(writer.set_height(-5.0));
  const double three_quarters = std::tan(1.5 * std::numbers::pi / 4.0);
  EXPECT_EQ(text_of(writer.cut(Place{5.0, 2.0}, Place{4.0, 1.0}, three_quarters)),
            "X3.293Y2.707Z-4I-0.9999\nX4Y1Z-5I0.707J-0.7071\n");
}

TEST(ProgramWriter, RisesBeforeARapidAndDescendsAfterIt) {
  ProgramWriter writer{PrintGrid{3}};
  EXPECT_TRUE(writer.set_height(-2.0));
  EXPECT_EQ(text_of(writer.rapid(Place{0.0, 0.0})), "G0Z-2\nX0Y0\n");
  EXPECT_TRUE(writer.set_height(5.0));
  EXPECT_EQ(text_of(writer.rapid(Place{9.0, 0.0})), "Z5\nX9\n");
  EXPECT_TRUE(writer.set_height(1.0));
  EXPECT_EQ(text_of(writer.rapid(Place{9.0, 4.0})), "Y4\nZ1\n");
  EXPECT_FALSE(writer.set_height(std::nan("")));
  EXPECT_FALSE(writer.set_height(5.1e5));
  EXPECT_EQ(text_of(writer.rapid(Place{9.0, 4.0})), "");
}

TEST(ProgramWriter, WritesArcsInThreePlanes) {
  ProgramWriter writer{PrintGrid{3}};
  writer.leave_power();
  writer.set_feed(300'000);
  EXPECT_TRUE(writer.set_height(5.0));
  EXPECT_EQ(text_of(writer.rapid(Place{1.0, 2.0})), "G0Z5\nX1Y2\n");
  EXPECT_EQ(writer.use_plane(Plane::kXY), "");
  EXPECT_EQ(writer.use_plane(Plane::kZX), "G18\n");
  EXPECT_EQ(text_of(writer.cut(Place{5.0, 1.0}, Place{5.0, 3.0}, -1.0)), "G2X3I1F300\n");
  EXPECT_EQ(
      text_of(writer.cut(Place{5.0, 3.0}, Place{6.0, 4.0}, std::tan(0.125 * std::numbers::pi))),
      "G3Z6X4I1\n");
  EXPECT_TRUE(writer.set_height(1.0));
  EXPECT_EQ(text_of(writer.cut(Place{6.0, 4.0}, Place{6.0, 5.0}, 0.0)), "G1X5Y1\n");
  EXPECT_EQ(writer.use_plane(Plane::kYZ), "G19\n");
  EXPECT_EQ(text_of(writer.cut(Place{1.0, 6.0}, Place{3.0, 6.0}, 1.0)), "G3Y3J1\n");
  EXPECT_TRUE(writer.set_height(7.0));
  EXPECT_EQ(text_of(writer.cut(Place{3.0, 6.0}, Place{3.0, 6.0}, 0.0)), "G1X7\n");
  EXPECT_EQ(writer.use_plane(Plane::kXY), "G17\n");
  EXPECT_EQ(text_of(writer.rapid(Place{7.0, 3.0})), "");
  EXPECT_EQ(text_of(writer.rapid(Place{0.0, 3.0})), "G0X0\n");
}

/// The exact arc before it is written, in long double.
struct MeantArc {
  long double x = 0.0L;
  long double y = 0.0L;
  long double radius = 0.0L;
  long double from = 0.0L;
  long double sweep = 0.0L;

  [[nodiscard]] Place at(long double share) const {
    const long double angle = from + share * sweep;
    return {static_cast<double>(x + radius * std::cos(angle)),
            static_cast<double>(y + radius * std::sin(angle))};
  }
  /// Returns the distance of a point from the circle.
  [[nodiscard]] long double off(long double place_x, long double place_y) const {
    return std::abs(std::hypot(place_x - x, place_y - y) - radius);
  }
};

long double in_mm(Coordinate coordinate) {
  return static_cast<long double>(coordinate.nanometres()) * 1.0e-6L;
}

/// Returns the number after a letter in the text of one line; 0 if the letter is missing.
double word(const std::string& line, char letter) {
  const std::size_t found = line.find(letter);
  return found == std::string::npos ? 0.0 : std::stod(line.substr(found + 1));
}

/// Reads lines back as the controller does, and checks arcs as Grbl 1.1 does.
class WriterReadBack : public InterpreterTest {
 protected:
  void read(const std::string& lines, const MeantArc& meant) {
    for (std::size_t begin = 0; begin < lines.size();) {
      const std::size_t end = lines.find('\n', begin);
      const std::string line = lines.substr(begin, end - begin);
      begin = end + 1;
      const Position start = interpreter.position();
      for (const Action& action : take(line)) {
        if (action.kind == ActionKind::kArc) judge(action, start, line, meant);
        if (action.kind == ActionKind::kLine) judge_line(action, start, meant);
      }
    }
  }

  double digit_mm = 0.001;
  long double worst_radii = 0.0L;  ///< Greatest difference of radii, in units of the last digit.
  long double worst_shape = 0.0L;
  int arcs = 0;

 private:
  void judge(const Action& arc, const Position& start, const std::string& line, const MeantArc& m) {
    ++arcs;
    const long double cx = in_mm(arc.centre[0]);
    const long double cy = in_mm(arc.centre[1]);
    const long double r0 = std::hypot(in_mm(start[0]) - cx, in_mm(start[1]) - cy);
    const long double r1 = std::hypot(in_mm(arc.end[0]) - cx, in_mm(arc.end[1]) - cy);
    worst_radii = std::max(worst_radii, std::abs(r0 - r1) / digit_mm);
    judge_as_grbl(start, arc.end, line);
    const long double first = std::atan2(in_mm(start[1]) - cy, in_mm(start[0]) - cx);
    long double sweep = std::atan2(in_mm(arc.end[1]) - cy, in_mm(arc.end[0]) - cx) - first;
    if (arc.clockwise && sweep > 0.0L) sweep -= 2.0L * std::numbers::pi_v<long double>;
    if (!arc.clockwise && sweep < 0.0L) sweep += 2.0L * std::numbers::pi_v<long double>;
    ASSERT_LT(std::abs(sweep), 1.05L * std::numbers::pi_v<long double>) << line;
    for (int i = 0; i <= 8; ++i) {
      const long double share = static_cast<long double>(i) / 8.0L;
      const long double angle = first + share * sweep;
      const long double radius = r0 + share * (r1 - r0);
      note_shape(m.off(cx + radius * std::cos(angle), cy + radius * std::sin(angle)));
    }
  }

  void judge_line(const Action& line, const Position& start, const MeantArc& m) {
    for (const long double share : {0.5L, 1.0L}) {
      note_shape(m.off(in_mm(start[0]) + share * (in_mm(line.end[0]) - in_mm(start[0])),
                       in_mm(start[1]) + share * (in_mm(line.end[1]) - in_mm(start[1]))));
    }
  }

  /// Checks by the rule of gcode.c in Grbl 1.1: error 33 if the radii differ by more than 0.005 mm,
  /// and either by more than 0.5 mm or by more than 0.1 %. Computes in float, from the digits of
  /// the line alone.
  static void judge_as_grbl(const Position& start, const Position& end, const std::string& line) {
    const auto i = static_cast<float>(word(line, 'I'));
    const auto j = static_cast<float>(word(line, 'J'));
    const auto x = static_cast<float>(in_mm(end[0])) - static_cast<float>(in_mm(start[0])) - i;
    const auto y = static_cast<float>(in_mm(end[1])) - static_cast<float>(in_mm(start[1])) - j;
    const float target = std::hypot(x, y);
    const float radius = std::hypot(i, j);
    const float off = std::abs(target - radius);
    EXPECT_FALSE(off > 0.005F && (off > 0.5F || off > 0.001F * radius)) << line;
  }

  void note_shape(long double off_mm) { worst_shape = std::max(worst_shape, off_mm / digit_mm); }
};

TEST_F(WriterReadBack, RandomArcsNeedNoRepairAndStayWithinADigit) {
  const proof::Trials trials{20'000};
  for (const std::uint64_t seed : trials) {
    SCOPED_TRACE(testing::Message() << "KERFLINE_SEED=" << seed);
    proof::Random random{seed};
    const auto decimals = static_cast<std::uint8_t>(3 + random.below(3));
    digit_mm = std::pow(10.0, -decimals);
    MeantArc meant{.x = random.between(-200.0, 200.0),
                   .y = random.between(-200.0, 200.0),
                   .radius = random.magnitude(2.0e-4, 900.0),
                   .from = random.between(-3.2, 3.2),
                   .sweep = random.signed_magnitude(1.0e-4, 6.2)};
    if (random.chance(0.1)) meant.sweep = random.chance(0.5) ? 3.14159265358979L : -1.570796326L;
    if (random.chance(0.2)) meant.from = 0.0L;
    interpreter = Interpreter{};
    take("G21G90F100");
    ProgramWriter writer{PrintGrid{decimals}};
    writer.set_feed(100'000);
    const std::string start = text_of(writer.rapid(meant.at(0.0L)));
    take(start.substr(0, start.size() - 1));
    const auto bulge = static_cast<double>(std::tan(meant.sweep / 4.0L));
    const auto lines = text_of(writer.cut(meant.at(0.0L), meant.at(1.0L), bulge));
    ASSERT_NE(lines, "refused");
    const long double before = worst_radii;
    read(lines, meant);
    EXPECT_LE(worst_radii, std::max(before, 0.15L)) << lines;
    EXPECT_LE(worst_shape, 1.0L) << lines;
    const Place end = meant.at(1.0L);
    EXPECT_LE(std::abs(in_mm(interpreter.position()[0]) - end.x()), 0.501 * digit_mm);
    EXPECT_LE(std::abs(in_mm(interpreter.position()[1]) - end.y()), 0.501 * digit_mm);
  }
  std::printf("%d arcs: radii unlike by %.3Lf, shape off by %.3Lf last digits at most\n",
              arcs,
              worst_radii,
              worst_shape);
}

/// Coordinates are floats as on the controller. The written arc must still be valid without a
/// repair.
TEST_F(WriterReadBack, ArcsInSinglePrecisionNeedNoRepair) {
  const proof::Trials trials{20'000};
  for (const std::uint64_t seed : trials) {
    SCOPED_TRACE(testing::Message() << "KERFLINE_SEED=" << seed);
    proof::Random random{seed};
    digit_mm = 0.001;
    const auto number = [&random] { return static_cast<float>(random.between(-100.0, 100.0)); };
    const Vec2 from{number(), number()};
    const Vec2 to{from + Vec2{0.2F * number(), 0.2F * number()}};
    const auto bulge = static_cast<float>(random.signed_magnitude(0.02, 1.0));
    interpreter = Interpreter{};
    take("G21G90F100");
    ProgramWriter writer{PrintGrid{3}};
    const auto start = text_of(writer.rapid(from));
    take(start.substr(0, start.size() - 1));
    writer.set_feed(100'000);
    const auto lines = text_of(writer.cut(from, to, bulge));
    ASSERT_NE(lines, "refused");
    // Only the controller's own digits are checked, as the exact arc is not known more exactly.
    read(lines, MeantArc{});
    EXPECT_LE(worst_radii, 0.5L) << lines;
  }
}

}  // namespace
}  // namespace cnc::gcode
