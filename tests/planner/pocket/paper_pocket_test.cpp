#include "planner/pocket/paper_pocket.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "tests/planner/pocket/pocket_bench.hpp"

namespace cnc::pocket {
namespace {

constexpr double kFactorOfThePaper = 1.516719;
constexpr double kPrintedTo = 2.5e-5;

/// The paper's program with its storage.
class PaperProgram {
 public:
  Result<std::uint32_t, PaperFault> write(const PocketBench& bench, double radius, double factor) {
    return write_paper_path<double>(
        bench.pocket(), {radius, -2.0, factor}, {elements_, distances_}, writer_);
  }
  [[nodiscard]] double distance(std::size_t loop) const { return distances_[loop]; }
  [[nodiscard]] ToolPathView<double> path() const { return writer_.view(); }

 private:
  std::array<contour::Curve<double>, 16> elements_{};
  std::array<double, 32> distances_{};
  std::array<PathPoint<double>, 256> points_{};
  std::array<std::uint32_t, 4> row_ends_{};
  ToolPathWriter<double> writer_{points_, row_ends_};
};

/// A point as the paper prints it, and the radius of the arc that leads to it.
struct Printed {
  std::size_t index;  ///< Index in the path; the line number is 30 + 10 times the index.
  double x, y;
  double radius = 0.0;
};

TEST(PaperPocket, ReproducesThePrintedStepsWithThePapersFactor) {
  PocketBench bench;
  PaperProgram program;
  const auto count = program.write(bench.paper(), 5.0, kFactorOfThePaper);
  ASSERT_TRUE(count.ok());
  ASSERT_EQ(count.value(), 8U);
  constexpr double kSteps[] = {
      6.865536, 7.192449, 7.456116, 7.675069, 7.860432, 8.019602, 8.157821};
  for (std::size_t i = 0; i < 7; ++i) {
    EXPECT_NEAR(program.distance(i + 1) - program.distance(i), kSteps[i], 2.0e-6) << i;
  }
}

TEST(PaperPocket, ReproducesThePrintedCoordinatesWithThePapersFactor) {
  PocketBench bench;
  PaperProgram program;
  ASSERT_TRUE(program.write(bench.paper(), 5.0, kFactorOfThePaper).ok());
  const auto path = program.path();
  ASSERT_EQ(path.row_ends.size(), 1U);
  ASSERT_EQ(path.points.size(), 41U);  // N30 to N430.
  for (const Printed& line : {Printed{0, 68.227020, 68.227020},
                              Printed{1, 71.772972, 68.227020},
                              Printed{2, 71.772972, 84.667664},
                              Printed{3, 68.904709, 87.953789, 158.227036},
                              Printed{4, 68.227020, 87.191383},
                              Printed{11, 87.950394, 52.049599},
                              Printed{33, 79.498878, 170.189560, 111.865540},
                              Printed{34, 21.865536, 105.352043},
                              Printed{35, 21.865536, 15.000000},
                              Printed{36, 125.000000, 15.000000},
                              Printed{37, 125.000000, 107.520065},
                              Printed{38, 84.609192, 186.351746, 105.000000},
                              Printed{39, 15.000000, 108.041405},
                              Printed{40, 15.000000, 15.000000}}) {
    const PathPoint<double>& point = path.points[line.index];
    EXPECT_NEAR(point.x, line.x, kPrintedTo) << 30 + 10 * line.index;
    EXPECT_NEAR(point.y, line.y, kPrintedTo) << 30 + 10 * line.index;
    EXPECT_EQ(point.z, -2.0);
    if (line.radius == 0.0) continue;
    const PathPoint<double>& from = path.points[line.index - 1];
    EXPECT_LT(from.bulge, 0.0);  // G02.
    const double chord = (point.point() - from.point()).norm();
    const double b = std::abs(from.bulge);
    EXPECT_NEAR(chord * (1.0 + b * b) / (4.0 * b), line.radius, kPrintedTo);
  }
}

TEST(PaperPocket, KeepsExactlyToTheDistanceOtherwise) {
  PocketBench bench;
  PaperProgram program;
  const auto count = program.write(bench.paper(), 5.0, 0.0);
  ASSERT_TRUE(count.ok());
  EXPECT_EQ(count.value(), 8U);
  // The slanted wall is 1.125 x − y + 98.75 = 0.
  const PathPoint<double>& corner = program.path().points[38];
  const double away = (1.125 * corner.x - corner.y + 98.75) / std::hypot(1.125, 1.0);
  EXPECT_NEAR(away, 5.0, 1.0e-12);
  PaperProgram exact_factor;
  ASSERT_TRUE(exact_factor.write(bench, 5.0, std::hypot(1.125, 1.0)).ok());
  EXPECT_NEAR(exact_factor.path().points[38].x, corner.x, 1.0e-12);
}

TEST(PaperPocket, OfASquareStepsByTheFormulaToTheMiddle) {
  PocketBench bench;
  PaperProgram program;
  const auto count = program.write(bench.rectangle(0, 0, 100, 60), 5.0, 0.0);
  ASSERT_TRUE(count.ok());
  EXPECT_EQ(count.value(), 3U);
  EXPECT_NEAR(program.distance(2), 5.0 + 10.0 * (1.0 + std::sqrt(0.5)), 1.0e-12);
}

TEST(PaperPocket, OfACircleHasNoVertexAndStepsByTheDiameter) {
  PocketBench bench;
  PaperProgram program;
  const auto count = program.write(bench.circle(0, 0, 24), 5.0, 0.0);
  ASSERT_TRUE(count.ok());
  EXPECT_EQ(count.value(), 2U);
  EXPECT_NEAR(program.distance(1), 15.0, 1.0e-12);
  for (const PathPoint<double>& point : program.path().points) {
    const double radius = point.point().norm();
    EXPECT_LT(std::min(std::abs(radius - 9.0), std::abs(radius - 19.0)), 1.0e-12);
  }
}

TEST(PaperPocket, ReportsWhatItCannotDo) {
  PaperProgram program;
  PocketBench island;
  island.rectangle(0, 0, 100, 100).round_island(50, 50, 10);
  EXPECT_EQ(program.write(island, 5.0, 0.0).error(), PaperFault::kNotOneLoop);
  PocketBench narrow;
  narrow.rectangle(0, 0, 100, 9);
  EXPECT_EQ(program.write(narrow, 5.0, 0.0).error(), PaperFault::kToolTooLarge);
  EXPECT_EQ(program.write(narrow, 0.0, 0.0).error(), PaperFault::kNotANumber);
  EXPECT_EQ(program.write(narrow, std::nan(""), 0.0).error(), PaperFault::kNotANumber);
  PocketBench large;
  large.rectangle(0, 0, 1000, 1000);
  EXPECT_EQ(program.write(large, 5.0, 0.0).error(), PaperFault::kTooManyPasses);
  EXPECT_EQ(program.write(large, 20.0, 0.0).ok(), true);
}

}  // namespace
}  // namespace cnc::pocket
