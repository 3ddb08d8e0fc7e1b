#include "host-sim/measure/path_deviation.hpp"

#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <random>

#include "tests/host-sim/measure/synthetic_trace.hpp"
#include "tests/support/trials.hpp"

namespace sim {
namespace {

/// Positions of a machine that moves along the path at 50 mm/s without ever stopping.
class Along {
 public:
  explicit Along(const ProgrammedPath& path) : path_{path} {
    for (const PathPiece& piece : path.pieces) ends_.push_back(length() + piece.curve.length());
  }
  [[nodiscard]] double length() const { return ends_.empty() ? 0.0 : ends_.back(); }
  [[nodiscard]] double end_s() const { return length() / kSpeed + 1.0e-3; }
  [[nodiscard]] Point operator()(double time) const {
    const double place = kSpeed * time;
    const auto end = std::upper_bound(ends_.begin(), ends_.end(), place);
    if (end == ends_.end()) return path_.end;
    const Curve& curve = path_.pieces[static_cast<std::size_t>(end - ends_.begin())].curve;
    return curve.point_at(1.0 - (*end - place) / curve.length());
  }

 private:
  static constexpr double kSpeed = 50.0;
  const ProgrammedPath& path_;
  std::vector<double> ends_;
};

PathDeviation followed(const ProgrammedPath& path, const SyntheticMachine& machine) {
  PathDeviation deviation{path, machine.steps_per_mm};
  const Along along{path};
  play(machine.rows(along, along.end_s()), deviation);
  return deviation;
}

void expect_ideal(const ProgrammedPath& path, const SyntheticMachine& machine = {}) {
  const PathDeviation deviation = followed(path, machine);
  double half_diagonal = 0.0;
  for (const double scale : machine.steps_per_mm) half_diagonal += 0.25 / (scale * scale);
  EXPECT_LE(deviation.greatest_distance().value, std::sqrt(half_diagonal) + 1.0e-6);
  EXPECT_LE(deviation.greatest_axis_excess().value, 1.0e-6)
      << "line " << deviation.greatest_axis_excess().line;
  EXPECT_LE(deviation.distance_to_end(), std::sqrt(half_diagonal) + 1.0e-6);
  EXPECT_TRUE(deviation.reached_last_piece());
}

TEST(PathDeviation, AnIdealMachineIsWithinHalfAStep) {
  expect_ideal(read_program("F3000\nG1X10Y3\nG2X15Y8I5J0\nG3X20Y3R30\nG1X0Y0Z2A4\n"));
  expect_ideal(read_program("F3000\nG2I7J3\nG18G3X3Z4Y6R9P2\nG19G2Y2Z1J1K1X5\n"));
}

TEST(PathDeviation, OutAndBackOverTheSameLine) {
  expect_ideal(read_program("F3000\nG1X10Y3\nG1X0Y0\nG1X10Y3\nG1X5Y1.5\nG1X10Y3\nG1X10Y10\n"));
  // The tip lies between two positions of the motors.
  expect_ideal(read_program("F3000\nG1X1.0061Y0.3019\nG1X0Y0\nG1X1.0063\nG1X-2\n"));
}

TEST(PathDeviation, OutAndBackInTinyPieces) {
  std::string program = "F3000 G91\n";
  for (int pass = 0; pass < 3; ++pass) {
    for (int i = 0; i < 1500; ++i) program += "G1X0.0011Y0.0007\n";
    for (int i = 0; i < 1500; ++i) program += "G1X-0.0011Y-0.0007\n";
  }
  expect_ideal(read_program(program));
}

TEST(PathDeviation, RastersCloserThanAStep) {
  std::string program = "F3000 G91\n";
  for (int i = 0; i < 20; ++i) program += "G1X5\nG1Y0.004\nG1X-5\nG1Y0.004\n";
  expect_ideal(read_program(program));
}

TEST(PathDeviation, CirclesRunThroughManyTimes) {
  std::string program = "F3000 G91\n";
  for (int i = 0; i < 5; ++i) program += "G2I1\nG3I1\nG2I0.03\nG3J-0.008\nG1X0.02\n";
  expect_ideal(read_program(program));
}

TEST(PathDeviation, TremblingBetweenTwoPlacesOfTheMotor) {
  std::string program = "F3000 G91\nG1X1.003\n";
  for (int i = 0; i < 500; ++i) program += "G1X0.0075Y0.0003\nG1X-0.0075Y-0.0003\n";
  expect_ideal(read_program(program + "G1X3Y1\nG1X-4\n"));
}

TEST(PathDeviation, UnlikeStepsAndRotaryAxes) {
  SyntheticMachine machine;
  machine.steps_per_mm = {80, 160, 400, 8.889, 2.0, 80};
  expect_ideal(read_program("F3000\nG1X3A20\nG1X0\nG1X3Z1\nG2X5Y2R2B9\nG1A0B0\nG1X0Y0\n"), machine);
}

TEST(PathDeviation, RandomPrograms) {
  const auto seed = static_cast<unsigned>(proof::test_seed());
  SCOPED_TRACE(testing::Message() << "KERFLINE_SEED=" << seed);
  std::mt19937 random{seed};
  std::uniform_int_distribution<int> kind{0, 5};
  std::uniform_real_distribution<double> exponent{-3.0, 0.7};
  std::uniform_real_distribution<double> angle{0.0, 6.28318};
  for (int trial = 0; trial < 25; ++trial) {
    std::string program = "F3000 G91\n";
    for (int i = 0; i < 60; ++i) {
      const double size = std::pow(10.0, exponent(random));
      const double turn = angle(random);
      const std::string x = std::to_string(size * std::cos(turn));
      const std::string y = std::to_string(size * std::sin(turn));
      const int choice = kind(random);
      if (choice < 3) program += "G1X" + x + "Y" + y + "\n";
      if (choice == 3)
        program += "G1X" + x + "\nG1X" + std::to_string(-size * std::cos(turn)) + "\n";
      if (choice == 4) program += "G2X" + x + "Y" + y + "R" + std::to_string(size) + "Z0.1\n";
      if (choice == 5) program += "G3I" + x + "J" + y + "\n";
    }
    const ProgrammedPath path = read_program(program);
    SCOPED_TRACE(testing::Message() << "trial " << trial);
    expect_ideal(path);
    if (testing::Test::HasFailure()) return;
  }
}

TEST(PathDeviation, MeasuresAnOffsetAndItsPlace) {
  const ProgrammedPath asked = read_program("F3000\nG1X10\nG1Y10\nG1X0\nG1Y0\n");
  const ProgrammedPath done = read_program("F3000\nG1X10.2\nG1Y10\nG1X0\nG1Y0\n");
  const SyntheticMachine machine;
  PathDeviation deviation{asked, machine.steps_per_mm};
  const Along along{done};
  play(machine.rows(along, along.end_s()), deviation);
  EXPECT_NEAR(deviation.greatest_distance().value, 0.2, 0.001);
  EXPECT_NEAR(deviation.greatest_axis_excess().value, 0.2 - 0.5 / 80.0, 0.001);
  EXPECT_EQ(deviation.greatest_distance().line, 2);
}

TEST(PathDeviation, NoticesAPartLeftOut) {
  const SyntheticMachine machine;
  const ProgrammedPath asked = read_program("F3000\nG1X10\nG1X10Y5\nG1X10Y0\nG1X20\n");
  const ProgrammedPath done = read_program("F3000\nG1X20\n");
  PathDeviation deviation{asked, machine.steps_per_mm};
  const Along along{done};
  play(machine.rows(along, along.end_s()), deviation);
  EXPECT_GT(deviation.greatest_distance().value, 1.0);
}

TEST(PathDeviation, ChordsInsteadOfArcsShowTheirSagitta) {
  const ProgrammedPath asked = read_program("F3000\nG2X20Y0I10J0\n");
  std::string chords = "F3000\n";
  for (int i = 1; i <= 10; ++i) {
    const double angle = 0.314159265 * i;
    chords += "G1X" + std::to_string(10.0 - 10.0 * std::cos(angle)) + "Y" +
              std::to_string(10.0 * std::sin(angle)) + "\n";
  }
  SyntheticMachine machine;
  machine.steps_per_mm.fill(800.0);
  const ProgrammedPath done = read_program(chords);
  PathDeviation deviation{asked, machine.steps_per_mm};
  const Along along{done};
  play(machine.rows(along, along.end_s()), deviation);
  EXPECT_NEAR(deviation.greatest_distance().value, 10.0 * (1.0 - std::cos(0.15708)), 0.001);
}

/// Expects the same deviation for legs that meet with the given turn, and for the arc that is 0.5
/// mm away from the corner.
void expect_place_round_corner(double turn) {
  SCOPED_TRACE(testing::Message() << "turn " << turn);
  const auto place = [](double x, double y) {
    return "X" + std::to_string(x) + "Y" + std::to_string(y);
  };
  constexpr double kLeg = 20.0;
  constexpr double kTolerance = 0.5;
  const double half = std::cos(turn / 2.0);
  const double radius = kTolerance * half / (1.0 - half);
  const double trim = radius * std::tan(turn / 2.0);
  const double c = std::cos(turn);
  const double s = std::sin(turn);
  const ProgrammedPath asked = read_program("F3000 G64 P0.5 Q0\nG1" + place(kLeg, 0.0) + "\n" +
                                            place(kLeg + kLeg * c, kLeg * s) + "\n");
  const ProgrammedPath done = read_program(
      "F3000\nG1" + place(kLeg - trim, 0.0) + "\nG3" + place(kLeg + trim * c, trim * s) + "R" +
      std::to_string(radius) + "\nG1" + place(kLeg + kLeg * c, kLeg * s) + "\n");
  SyntheticMachine machine;
  machine.steps_per_mm.fill(400.0);
  PathDeviation deviation{asked, machine.steps_per_mm};
  const Along along{done};
  play(machine.rows(along, along.end_s()), deviation);
  // The middle of the arc is its point farthest from both legs.
  EXPECT_NEAR(deviation.greatest_distance().value, radius * (1.0 - half), 0.004);
  EXPECT_TRUE(deviation.reached_last_piece());
}

TEST(PathDeviation, KnowsItsPlaceRoundACornerWithinItsTolerance) {
  for (const double turn : {0.5, 1.0, 1.57, 2.2, 2.8}) expect_place_round_corner(turn);
}

TEST(PathDeviation, LongProgramsTakeTimeLinearInTheirRows) {
  std::string program = "F3000 G91\n";
  for (int i = 0; i < 10'000; ++i) program += i % 2 == 0 ? "G1X0.08Y0.05\n" : "G1X0.09Y-0.05\n";
  const ProgrammedPath path = read_program(program);
  const SyntheticMachine machine;
  PathDeviation deviation{path, machine.steps_per_mm};
  TraceRow row;
  std::size_t rows = 0;
  const auto begin = std::chrono::steady_clock::now();
  for (const PathPiece& piece : path.pieces) {
    for (int i = 0; i < 20; ++i, ++rows) {
      const Point place = piece.curve.point_at(i / 20.0);
      for (std::size_t axis = 0; axis < 2; ++axis) {
        row.position[axis] = static_cast<std::int32_t>(std::lround(place[axis] * 80.0));
      }
      deviation.on_row(row);
    }
  }
  const std::chrono::duration<double> spent = std::chrono::steady_clock::now() - begin;
  EXPECT_EQ(rows, 200'000U);
  EXPECT_LE(deviation.greatest_axis_excess().value, 1.0e-6);
  // The limit allows for sanitizers on a busy machine; quadratic work would take minutes.
  EXPECT_LT(spent.count(), 20.0);
}

TEST(PathDeviation, APathWithoutMotionIsItsStart) {
  const ProgrammedPath path = read_program("G4P1\n");
  PathDeviation deviation{path, SyntheticMachine{}.steps_per_mm};
  TraceRow row;
  row.position[0] = 80;
  deviation.on_row(row);
  EXPECT_DOUBLE_EQ(deviation.greatest_distance().value, 1.0);
}

}  // namespace
}  // namespace sim
