#include <array>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <random>
#include <utility>

#include "planner/geometry/arc_elements.hpp"
#include "tests/planner/gcode/interpreter_test.hpp"
#include "tests/support/random_source.hpp"
#include "tests/support/trials.hpp"

namespace cnc::gcode {
namespace {

struct Circle {
  const char* line;
  Plane plane;
  bool clockwise;
  std::array<std::int64_t, 2> centre_um;  ///< Centre in the order of the plane's axes, µm.
  Position end;
  int turns = 1;
};

Coordinate um(std::int64_t micrometres) { return Coordinate{micrometres * 1'000}; }
Coordinate coordinate_mm(double mm) { return Coordinate{std::llround(mm * 1.0e6)}; }

class ArcWords : public InterpreterTest {
 protected:
  ArcWords() { place_at_1_2_3(); }

  void place_at_1_2_3() {
    interpreter = Interpreter{};
    interpreter.set_position({mm(1), mm(2), mm(3)});
    static_cast<void>(take("F60"));
  }

  void start_at_origin(const ArcTolerance& tolerance = {}) {
    interpreter = Interpreter{Options{.arc = tolerance}};
    static_cast<void>(take("F60"));
  }
};

// All circles begin at (1, 2, 3).
const Circle kCircles[]{
    {"G2 X11 Y2 I5", Plane::kXY, true, {6000, 2000}, {mm(11), mm(2), mm(3)}},
    {"G3 X11 Y2 I5", Plane::kXY, false, {6000, 2000}, {mm(11), mm(2), mm(3)}},
    {"G3 X11 I5 J0", Plane::kXY, false, {6000, 2000}, {mm(11), mm(2), mm(3)}},
    {"G2 X1 Y2 I-5", Plane::kXY, true, {-4000, 2000}, {mm(1), mm(2), mm(3)}},
    {"G2 X1 J5", Plane::kXY, true, {1000, 7000}, {mm(1), mm(2), mm(3)}},
    {"G2 Y2 J5 P4", Plane::kXY, true, {1000, 7000}, {mm(1), mm(2), mm(3)}, 4},
    {"G3 X11 Z9 A90 I5 P2", Plane::kXY, false, {6000, 2000}, {mm(11), mm(2), mm(9), mm(90)}, 2},
    {"G91 G2 X10 Z-1 I5", Plane::kXY, true, {6000, 2000}, {mm(11), mm(2), mm(2)}},
    {"G90.1 G2 X11 I6 J2", Plane::kXY, true, {6000, 2000}, {mm(11), mm(2), mm(3)}},
    {"G91 G90.1 G2 X10 I6 J2", Plane::kXY, true, {6000, 2000}, {mm(11), mm(2), mm(3)}},
    {"G18 G2 X11 I5", Plane::kZX, true, {3000, 6000}, {mm(11), mm(2), mm(3)}},
    {"G18 G3 Z13 K5 Y7", Plane::kZX, false, {8000, 2000 / 2}, {mm(1), mm(7), mm(13)}},
    {"G18 G90.1 G3 Z13 K8 I1", Plane::kZX, false, {8000, 1000}, {mm(1), mm(2), mm(13)}},
    {"G19 G2 Y12 J5", Plane::kYZ, true, {7000, 3000}, {mm(1), mm(12), mm(3)}},
    {"G19 G3 Z13 K5 X0", Plane::kYZ, false, {2000, 8000}, {mm(0), mm(2), mm(13)}},
    {"G2 X11 R5", Plane::kXY, true, {6000, 2000}, {mm(11), mm(2), mm(3)}},
    {"G3 X11 R-5", Plane::kXY, false, {6000, 2000}, {mm(11), mm(2), mm(3)}},
    {"G2 X7 R5", Plane::kXY, true, {4000, -2000}, {mm(7), mm(2), mm(3)}},
    {"G2 X7 R-5", Plane::kXY, true, {4000, 6000}, {mm(7), mm(2), mm(3)}},
    {"G3 X7 R5", Plane::kXY, false, {4000, 6000}, {mm(7), mm(2), mm(3)}},
    {"G3 X7 R-5 Z4", Plane::kXY, false, {4000, -2000}, {mm(7), mm(2), mm(4)}},
    {"G18 G3 Z9 R5", Plane::kZX, false, {6000, 5000}, {mm(1), mm(2), mm(9)}},
    {"G19 G2 Y8 R5", Plane::kYZ, true, {5000, -1000}, {mm(1), mm(8), mm(3)}},
    {"G2 X11 R5 P3", Plane::kXY, true, {6000, 2000}, {mm(11), mm(2), mm(3)}, 3},
    {"G2 X11.02 R5", Plane::kXY, true, {6010, 2000}, {um(11'020), mm(2), mm(3)}},
    {"G20 G2 X1 Y1 R50", Plane::kXY, true, {-1, -1}, {um(25'400), um(25'400), mm(3)}},
};

// The far side of a circle may extend along an axis for which the line has no word.
TEST_F(ArcWords, NameTheAxisThatTheFarSideIsBeyond) {
  Options options{};
  options.reach.fill(mm(100));
  for (const auto& [line, words] :
       {std::pair{"G2 X0 J60", "Y would be 120.000, limit 100.000"},
        std::pair{"G2 Y0 I-60", "X would be -120.000, limit 100.000"},
        std::pair{"G2 X1 Y1 R-99", "X would be"},
        std::pair{"G18 G3 X0 K60", "Z would be 120.000, limit 100.000"}}) {
    interpreter = Interpreter{options};
    static_cast<void>(take("F60"));
    EXPECT_EQ(words_of(refuse(line)).rfind(words, 0), 0U) << line << ": " << words_of(refuse(line));
  }
}

TEST_F(ArcWords, HaveTheirCentrePlaneDirectionAndTurns) {
  for (const Circle& want : kCircles) {
    place_at_1_2_3();
    const Action arc = take_one(want.line);
    EXPECT_EQ(arc.kind, ActionKind::kArc) << want.line;
    EXPECT_EQ(arc.plane, want.plane) << want.line;
    EXPECT_EQ(arc.clockwise, want.clockwise) << want.line;
    EXPECT_EQ(arc.end, want.end) << want.line;
    EXPECT_EQ(arc.turns, want.turns) << want.line;
    EXPECT_EQ(arc.feed, 1.0F) << want.line;
    if (want.centre_um[0] == -1) continue;
    for (std::size_t i = 0; i < 2; ++i) {
      const auto off = arc.centre[i].nanometres() - want.centre_um[i] * 1000;
      EXPECT_LE(std::abs(off), 2) << want.line << ", axis " << i;
    }
  }
}

TEST_F(ArcWords, OffsetsAreExact) {
  start_at_origin();
  const Action arc = take_one("G2 X0 Y0 I10.123456 J-0.000001");
  EXPECT_EQ(arc.centre[0].nanometres(), 10'123'456);
  EXPECT_EQ(arc.centre[1].nanometres(), -1);
}

TEST_F(ArcWords, AbsoluteCentresHaveTheOffsetsOfTheirCoordinates) {
  start_at_origin();
  static_cast<void>(take("G10 L2 P1 X100 Z50"));
  static_cast<void>(take("G43.1 Z5"));
  static_cast<void>(take("G18 G90.1 G0 X0 Z0"));
  const Action arc = take_one("G2 X10 Z0 I5 K0");
  EXPECT_EQ(arc.centre[0], mm(55));
  EXPECT_EQ(arc.centre[1], mm(105));
}

TEST_F(ArcWords, AFlatArcOnALargeCircleStaysWhereItsEndsAre) {
  start_at_origin();
  // The far side of this circle is more than 500 m away.
  const Action arc = take_one("G91 G3 X.04 Y.03 I-402653.2024 J536870.9782");
  const CentreArc programmed{
      .end = arc.end, .plane = arc.plane, .centre = arc.centre, .clockwise = arc.clockwise};
  EXPECT_EQ(ArcElements{programmed}.count(), 1U);
}

/// The elements of an accepted arc stay within the reach that the interpreter has checked, so no
/// later stage can refuse them.
TEST_F(ArcWords, OfAnySizeHaveTheirElementsWithinReach) {
  const proof::Trials trials{20'000};
  Options options{};
  options.reach.fill(mm(500'000));
  std::uint64_t taken = 0;
  for (const std::uint64_t seed : trials) {
    SCOPED_TRACE(testing::Message() << "KERFLINE_SEED=" << seed);
    proof::Random random{seed};
    interpreter = Interpreter{options};
    const Position start{coordinate_mm(random.between(-4.9e5, 4.9e5)),
                         coordinate_mm(random.between(-4.9e5, 4.9e5))};
    interpreter.set_position(start);
    static_cast<void>(take("F60 G91"));
    const double radius = random.magnitude(1.0e-3, 1.0e6);
    const double angle = random.between(-4.0, 4.0);
    const double turn =
        random.chance(0.5) ? random.magnitude(1.0e-6, 10.0) / radius : random.between(-6.3, 6.3);
    const double i = -radius * std::cos(angle);
    const double j = -radius * std::sin(angle);
    const int way = random.chance(0.5) ? 2 : 3;
    const int turns = random.chance(0.1) ? 2 : 1;
    std::array<char, 160> line{};
    std::snprintf(line.data(),
                  line.size(),
                  "G%d X%.6f Y%.6f I%.6f J%.6f P%d",
                  way,
                  i + radius * std::cos(angle + turn),
                  j + radius * std::sin(angle + turn),
                  i,
                  j,
                  turns);
    const auto actions = interpreter.interpret(line.data());
    if (!actions.ok() || actions.value().empty()) continue;
    const Action& arc = actions.value()[0];
    const ArcElements elements{{.start = start,
                                .end = arc.end,
                                .plane = arc.plane,
                                .centre = arc.centre,
                                .clockwise = arc.clockwise,
                                .turns = arc.turns}};
    ++taken;
    for (std::uint32_t k = 0; k < elements.count(); ++k) {
      for (const Coordinate& axis : elements.element(k).end) {
        ASSERT_LE(std::abs(axis.mm()), 500'001.0F) << line.data();
      }
    }
  }
  EXPECT_GT(3 * taken, trials.count());
}

TEST_F(ArcWords, ACentreThatIsRoundedToTheStartIsRefused) {
  start_at_origin();
  EXPECT_EQ(refuse("G91 G2 X.000001 R.000001").detail, FaultDetail::kCentreIsStart);
  static_cast<void>(take("G91 G2 X.000002 R.000001"));
}

TEST_F(ArcWords, ASmallestCircleIsACircle) {
  start_at_origin();
  const Action arc = take_one("G2 X0 I0.000001");
  EXPECT_EQ(arc.centre[0], Coordinate{1});
  EXPECT_EQ(arc.end, Position{});
}

TEST_F(ArcWords, TheFarthestCentreIsAtTheEndOfTheRange) {
  start_at_origin();
  // A short arc around this centre stays in range; the complete circle does not.
  const Action& arc = take_one("G3 X0.5 Y-1000 I1000000");
  EXPECT_EQ(arc.centre[0], mm(1'000'000));
  start_at_origin();
  EXPECT_EQ(refusal_number("G2 X0 I1000000"), 33);
  EXPECT_EQ(refusal_number("G3 X0.5 Y-1000 I1000000.000001"), 33);
}

struct Deviation {
  const char* line;
  const char* words;
};

TEST_F(ArcWords, RefusalsTellTheDeviationAndTheLimit) {
  const Deviation deviations[]{
      {"G2 X10 I4.9", "arc end is 0.200 mm off its circle, limit 0.050 mm"},
      {"G2 X10.123 I5", "arc end is 0.123 mm off its circle, limit 0.050 mm"},
      {"G2 X100 Y0 I49", "arc end is 2.000 mm off its circle, limit 0.490 mm"},
      {"G2 X1000 I499", "arc end is 2.000 mm off its circle, limit 0.500 mm"},
      {"G2 X10.2 R5",
       "arc end is 0.200 mm farther from its start than the diameter, limit 0.050 mm"},
      {"G2 X10 R0", "arc radius is zero"},
      {"G2 X0 R5", "arc with R ends where it starts"},
      {"G2 X10 I0", "arc centre is its start"},
      {"G2 X0 I10000000", "arc centre would be at 10000000.000 mm, limit 1000000.000 mm"},
      {"G2 X10 R10000000", "arc radius is 10000000.000 mm, limit 1000000.000 mm"},
      {"G2 X10", "arc has neither R nor a centre in its plane"},
      {"G90.1 G2 X10 J5", "I is missing: G90.1 needs the whole centre"},
  };
  start_at_origin();
  for (const Deviation& deviation : deviations) {
    EXPECT_EQ(words_of(refuse(deviation.line)), deviation.words) << deviation.line;
  }
}

TEST_F(ArcWords, ToleranceCanBeSetButNotBelowGrbls) {
  start_at_origin({.absolute_mm = 0.3F, .relative = 0.0F});
  EXPECT_EQ(take("G2 X10 I4.86").size(), 1U);
  start_at_origin({.absolute_mm = 0.0F, .relative = 0.0F});
  EXPECT_EQ(take("G2 X0.004 Y0 I10").size(), 1U);
  EXPECT_EQ(refusal_number("G2 X0 I10.03 Y0.6"), 33);
  start_at_origin({.absolute_mm = 9.0F, .relative = 9.0F});
  EXPECT_EQ(refusal_number("G2 X10 I4.7"), 33);
}

/// Arcs as CAM programs write them: exact geometry, with each number rounded to `decimals`.
class RoundedArcs : public ArcWords {
 protected:
  void check(int decimals, double smallest_radius) {
    const std::uint64_t seed = proof::test_seed();
    SCOPED_TRACE(testing::Message() << "KERFLINE_SEED=" << seed << ", decimals " << decimals);
    std::mt19937_64 random{seed};
    std::uniform_real_distribution<double> angle{-std::numbers::pi, std::numbers::pi};
    std::uniform_real_distribution<double> log_radius{std::log(smallest_radius), std::log(2000.0)};
    for (int trial = 0; trial < 20'000; ++trial) {
      const double radius = std::exp(log_radius(random));
      const double from = angle(random);
      const double to = angle(random);
      start_at_origin();
      char line[120];
      std::snprintf(line,
                    sizeof line,
                    "%s X%.*f Y%.*f I%.*f J%.*f",
                    trial % 2 == 0 ? "G2" : "G3",
                    decimals,
                    radius * (std::cos(to) - std::cos(from)),
                    decimals,
                    radius * (std::sin(to) - std::sin(from)),
                    decimals,
                    -radius * std::cos(from),
                    decimals,
                    -radius * std::sin(from));
      ASSERT_TRUE(interpreter.interpret(line).ok()) << line;
    }
  }
};

TEST_F(RoundedArcs, OfTwoDecimalsAreAccepted) { check(2, 0.05); }
TEST_F(RoundedArcs, OfThreeDecimalsAreAccepted) { check(3, 0.05); }
TEST_F(RoundedArcs, OfFourDecimalsAreAccepted) { check(4, 0.05); }

}  // namespace
}  // namespace cnc::gcode
