#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "host-sim/machine/probe_surface.hpp"
#include "host-sim/machine/simulator.hpp"
#include "host-sim/surface/probe_log.hpp"
#include "host-sim/surface/probe_program.hpp"
#include "host-sim/surface/probe_rows.hpp"
#include "host-sim/surface/probe_tip.hpp"
#include "host-sim/surface/probed_points.hpp"
#include "tests/host-sim/surface/support.hpp"

// Tests the complete cycle from a surface to the grid that the simulated machine probes on it.

namespace sim::surface {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr double kZStepMm = 1.0 / 250.0;
constexpr double kReportMm = 0.5e-3;  ///< Rounding of the coordinates in [PRB:…].
constexpr double kMeshPitchMm = 0.25;

/// A surface over X and Y from −8 to 28. Its mesh is at most `chord_mm` below and above it.
struct Shape {
  const char* name;
  std::function<double(const Vector2d&)> height;
  double chord_mm;
  double radius_mm;  ///< Radius, mm: positive for a dome, negative for a bowl, 0 for a plane or a
                     ///< ridge.
};

Mesh mesh_of(const Shape& shape) {
  PointGrid grid{.rows = 145, .columns = 145, .points = {}};
  for (std::size_t i = 0; i < grid.rows * grid.columns; ++i) {
    const Vector2d at{-8.0 + kMeshPitchMm * static_cast<double>(i % grid.columns),
                      -8.0 + kMeshPitchMm * static_cast<double>(i / grid.columns)};
    grid.points.emplace_back(at.x(), at.y(), shape.height(at));
  }
  return triangulated(grid);
}

/// Returns a cap with its middle at X and Y 10.
Shape cap(double radius_mm) {
  const double sense = radius_mm > 0.0 ? 1.0 : -1.0;
  const auto height = [=](const Vector2d& at) {
    const double square = radius_mm * radius_mm - (at - Vector2d{10, 10}).squaredNorm();
    return sense * (std::sqrt(square) - std::abs(radius_mm));
  };
  // The points are at most 26 mm from the middle. The diagonal of a cell is a chord, whose error
  // the slope there increases.
  const double steep = 1.0 - 26.0 * 26.0 / (radius_mm * radius_mm);
  const double chord =
      kMeshPitchMm * kMeshPitchMm / (4.0 * std::abs(radius_mm) * std::pow(steep, 1.5));
  return {radius_mm > 0.0 ? "dome" : "bowl", height, chord, radius_mm};
}

Shape slope() {
  return {
      "slope", [](const Vector2d& at) { return -2.0 + 0.4 * at.x() - 0.3 * at.y(); }, 1e-9, 0.0};
}

Shape roof_of(double rise) {
  return {"roof", [=](const Vector2d& at) { return -rise * std::abs(at.x() - 9.25); }, 1e-9, 0.0};
}

struct MachineRun {
  std::string log;
  int alarm = 0;
};

MachineRun run_on_machine(const ProbeProgram& program, const Mesh& mesh) {
  MachineRun run;
  Simulator simulator{
      text_of_probe_program(program),
      {.machine = {.probe_plate_z_mm = -1000.0,
                   .probe_surface = std::make_shared<const ProbeSurface>(mesh, program.tip_mm),
                   .has_switches = false},
       .on_answer = [&run](std::string_view line) { run.log += std::string{line} + "\n"; }}};
  const RunResult result = simulator.run();
  EXPECT_TRUE(result.refusals.empty());
  run.alarm = result.alarm;
  return run;
}

ProbePlan plan_for(const ProbeProgram& program, const ProbeLog& log) {
  const ProbeHeading heading = read_probe_heading(text_of_probe_program(program), "f");
  return {.grid = heading.grid,
          .depth_mm = heading.depth_mm,
          .touches = heading.touches,
          .has_guards = heading.has_guards,
          .offset = log.offset.value_or(Vector3d::Zero())};
}

ProbedPoints probed_by(const ProbeProgram& program, const std::string& text) {
  const ProbeLog log = read_probe_log(text);
  return probed_points(log, plan_for(program, log), "log");
}

/// Returns the touched points, read back from the file that the command writes.
PointGrid grid_of(const ProbeProgram& program, const ProbedPoints& probed) {
  const auto points = touched_points(program.grid, probed.points, program.tip_mm);
  SurfaceInput input =
      read_surface(text_of_probe_rows(program.grid, points, {"a test"}), "grid", {});
  EXPECT_TRUE(input.grid.has_value());
  EXPECT_EQ(input.grid->rows, program.grid.y.count);
  return *input.grid;
}

ProbeProgram program_for(double tip_mm, double pitch_mm) {
  return {.grid = {.x = span_of_pitch(0, 20, pitch_mm), .y = span_of_pitch(0, 20, pitch_mm)},
          .safe_mm = 14,
          .depth_mm = -16,
          .feed = 400,
          .tip_mm = tip_mm};
}

/// Returns how far a touched point may be above a cap or a plane, as touched_points() documents.
double max_above(const Shape& shape, const ProbeProgram& program, const Vector2d& at) {
  const double r = 0.5 * program.tip_mm;
  const double pitch = program.grid.min_pitch_mm();
  double third = 0.0;
  double steep = 0.5;
  double dome = 0.0;
  if (shape.radius_mm != 0.0) {
    const double q = std::abs(shape.radius_mm + r);  // For the cap of the tip itself.
    // The neighbours are one pitch farther out.
    const double away = (at - Vector2d{10, 10}).norm() + 2.0 * pitch;
    third = 3.0 * away * q * q / std::pow(q * q - away * away, 2.5);
    steep = away / std::sqrt(q * q - away * away);
    dome = std::max(0.0, r / shape.radius_mm);
  }
  const double off = std::sqrt(2.0) * (pitch * pitch * third / 3.0 +
                                       2.0 * (kZStepMm + kReportMm + shape.chord_mm) / pitch);
  const double above = r * (1.0 - std::cos(off)) * (1.0 + dome) * std::sqrt(1.0 + steep * steep);
  return 1.1 * above + kReportMm + shape.chord_mm + ProbeSurface::kPointRadiusMm;
}

class ProbeCircle : public testing::TestWithParam<double> {};

TEST_P(ProbeCircle, ReturnsTheSurface) {
  const double tip_mm = GetParam();
  for (const Shape& shape : {cap(45.0), cap(-45.0), slope()}) {
    const ProbeProgram program = program_for(tip_mm, 2.0);
    const MachineRun run = run_on_machine(program, mesh_of(shape));
    EXPECT_EQ(run.alarm, 0);
    const ProbedPoints probed = probed_by(program, run.log);
    ASSERT_THAT(probed.faults, testing::IsEmpty()) << shape.name;
    EXPECT_THAT(probed.notes, testing::IsEmpty());
    double least = 0.0;
    double most = 0.0;
    for (const Vector3d& point : grid_of(program, probed).points) {
      const double off = point.z() - shape.height(point.head<2>());
      least = std::min(least, off);
      most = std::max(most, off);
      EXPECT_GT(off, -kZStepMm - kReportMm - shape.chord_mm) << shape.name;
      EXPECT_LE(off, max_above(shape, program, point.head<2>())) << shape.name << point.transpose();
    }
    EXPECT_LT(most, 1.0e-3) << shape.name;
    RecordProperty(fmt::format("{}_least_nm", shape.name), static_cast<int>(1.0e6 * least));
    RecordProperty(fmt::format("{}_most_nm", shape.name), static_cast<int>(1.0e6 * most));
  }
}

INSTANTIATE_TEST_SUITE_P(Tips, ProbeCircle, testing::Values(0.0, 1.0, 2.0, 4.0));

TEST(ProbedCircle, IsTheSameInTwoTouchesAndWithHops) {
  const Shape shape = cap(45.0);
  const Mesh mesh = mesh_of(shape);
  ProbeProgram program = program_for(2.0, 4.0);
  const ProbedPoints plain = probed_by(program, run_on_machine(program, mesh).log);
  program.fast_feed = 900;
  program.retract_mm = 1.5;
  const ProbedPoints twice = probed_by(program, run_on_machine(program, mesh).log);
  program.hop_mm = 3;
  const MachineRun run = run_on_machine(program, mesh);
  EXPECT_EQ(run.alarm, 0);
  const ProbedPoints hops = probed_by(program, run.log);
  EXPECT_THAT(hops.faults, testing::IsEmpty());
  EXPECT_THAT(hops.notes, testing::IsEmpty());
  for (std::size_t i = 0; i < plain.points.size(); ++i) {
    EXPECT_EQ(twice.points[i], plain.points[i]) << i;
    EXPECT_EQ(hops.points[i], plain.points[i]) << i;
  }
}

TEST(ProbedCircle, IsNeverBelowARidgeThatIsSharperThanTheBall) {
  for (const double tip_mm : {1.0, 2.0, 4.0}) {
    for (const double rise : {0.2, 1.0, 2.5}) {
      const Shape shape = roof_of(rise);
      const ProbeProgram program{.grid = {.x = span_of_pitch(0, 18, 0.5), .y = {0, 6, 4}},
                                 .safe_mm = 3,
                                 .depth_mm = -30,
                                 .feed = 600,
                                 .tip_mm = tip_mm};
      const ProbedPoints probed = probed_by(program, run_on_machine(program, mesh_of(shape)).log);
      ASSERT_THAT(probed.faults, testing::IsEmpty());
      const double r = 0.5 * tip_mm;
      for (const Vector3d& point : grid_of(program, probed).points) {
        const double off = point.z() - shape.height(point.head<2>());
        EXPECT_GT(off, -kZStepMm - kReportMm - 1e-5) << tip_mm << ' ' << rise;
        EXPECT_LE(off, r * (std::sqrt(1.0 + rise * rise) - 1.0) + 1e-5) << tip_mm << ' ' << rise;
      }
    }
  }
}

TEST(ProbedCircle, GoesOnBehindPointsThatItMisses) {
  Mesh mesh = mesh_of(slope());
  // The part has a hole about X 8, Y 4.
  std::erase_if(mesh.facets, [&](const Facet& facet) {
    return std::ranges::any_of(facet, [&](std::uint32_t corner) {
      return (mesh.points[corner].head<2>() - Vector2d{8, 4}).norm() < 2.0;
    });
  });
  const ProbeProgram program = program_for(0.0, 4.0);
  const MachineRun run = run_on_machine(program, mesh);
  EXPECT_EQ(run.alarm, 0);
  const ProbedPoints probed = probed_by(program, run.log);
  EXPECT_THAT(probed.faults,
              testing::ElementsAre(testing::HasSubstr(
                  "row 2, column 3 (X 8, Y 4) touched nothing down to Z -16.000")));
  // The reader of surfaces reports the gap, and fills it if it is allowed to.
  const std::string text = text_of_probe_rows(program.grid, probed.points, {});
  EXPECT_THAT(refusal_of(text), testing::HasSubstr("row 2, column 3"));
  const SurfaceInput repaired = read_surface(text, "f", {.repair = true});
  EXPECT_NEAR(repaired.mesh.points[6 + 2].z(), slope().height({8, 4}), 0.01);
}

TEST(ProbedCircle, IsStoppedByAWallOnItsWay) {
  // The surface has a step of 10 mm at X 9.
  const Shape step{"step", [](const Vector2d& at) { return at.x() < 9.0 ? -10.0 : 0.0; }, 0.0, 0.0};
  ProbeProgram program = program_for(2.0, 4.0);
  program.hop_mm = 2;
  const MachineRun run = run_on_machine(program, mesh_of(step));
  EXPECT_EQ(run.alarm, 4) << "the tip is at the wall, and stays";
  const ProbeLog log = read_probe_log(run.log);
  ASSERT_FALSE(log.answers.empty());
  const ProbeAnswer& wall = log.answers[log.answers.size() - 2];
  EXPECT_TRUE(wall.is_touch);
  EXPECT_NEAR(wall.place.x(), 8.0, 0.3);
  program.hop_mm = 0;
  const MachineRun safe = run_on_machine(program, mesh_of(step));
  EXPECT_EQ(safe.alarm, 0);
  EXPECT_THAT(probed_by(program, safe.log).faults, testing::IsEmpty());
}

}  // namespace
}  // namespace sim::surface
