#include "host-sim/machine/probe_surface.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <string>

#include "host-sim/machine/probe_model.hpp"
#include "host-sim/machine/simulator.hpp"

namespace sim {
namespace {

constexpr double kProbedStepMm = 1.0 / 250.0;

/// Returns a roof whose ridge is at X 10 and height 0, with slopes of 45 degrees down to −10.
surface::Mesh roof() {
  return {
      .points =
          {{0, -20, -10}, {0, 20, -10}, {10, -20, 0}, {10, 20, 0}, {20, -20, -10}, {20, 20, -10}},
      .facets = {{0, 2, 1}, {1, 2, 3}, {2, 4, 3}, {3, 4, 5}}};
}

MachineModel machine_over(const surface::Mesh& mesh, double tip_mm) {
  return {.probe_plate_z_mm = -1000.0,
          .probe_surface = std::make_shared<const ProbeSurface>(mesh, tip_mm)};
}

double height_of(const ProbeSurface& surface, double x_mm, double y_mm) {
  ProbeSurface::Hint hint;
  return surface.tip_height(x_mm, y_mm, hint);
}

TEST(ProbeSurface, IsTheSurfaceItselfForAPoint) {
  const ProbeSurface surface{roof(), 0.0};
  for (const double x : {0.5, 3.0, 9.999, 10.0, 12.0}) {
    EXPECT_NEAR(height_of(surface, x, 1.0), -std::abs(x - 10.0), 1.0e-5) << x;
  }
  EXPECT_EQ(height_of(surface, 21.0, 0.0), cnc::surface::kNoContact);
  EXPECT_EQ(surface.top_mm(), 0.0);
}

TEST(ProbeSurface, HoldsABallAwayFromASlope) {
  const ProbeSurface surface{roof(), 2.0};
  // The ball of radius 1 touches at the point where its normal is that of the slope. Its tip is √2
  // − 1 higher.
  EXPECT_NEAR(height_of(surface, 5.0, 0.0), -5.0 + std::sqrt(2.0) - 1.0, 1.0e-12);
  EXPECT_NEAR(height_of(surface, 10.0, 0.0), 0.0, 1.0e-12);
}

TEST(ProbeModel, TellsContactsApartFromFreePlaces) {
  const MachineModel machine = machine_over(roof(), 0.0);
  ProbeModel probe{machine};
  cnc::Settings settings;
  probe.place(settings);
  const auto steps = settings.get(cnc::setting::kStepsPerMm, 0);
  const auto closed = [&](double x, double z) {
    PlayModel::Steps axes{};
    axes[0] = static_cast<std::int32_t>(std::lround(x * static_cast<double>(steps)));
    axes[2] = static_cast<std::int32_t>(
        std::lround(z * static_cast<double>(settings.get(cnc::setting::kStepsPerMm, 2))));
    return probe.is_closed(axes);
  };
  EXPECT_TRUE(closed(5.0, -5.004));
  EXPECT_FALSE(closed(5.0, -4.996));
  EXPECT_TRUE(closed(12.0, -3.0));
  EXPECT_FALSE(closed(12.0, 3.0));
  EXPECT_FALSE(closed(30.0, -900.0)) << "nothing is under it";
  EXPECT_TRUE(closed(30.0, -1000.0)) << "the plate";
}

TEST(ProbeModel, FindsAContactWhereverItComesFrom) {
  const MachineModel machine = machine_over(roof(), 1.0);
  ProbeModel probe{machine};
  const cnc::Settings settings;
  probe.place(settings);
  // If the circuit is open, no motion of this number of steps closes it.
  for (std::int32_t z = -3000; z < 3000; z += 7) {
    PlayModel::Steps axes{};
    axes[0] = 1000 + z / 5;
    axes[2] = z;
    if (probe.is_closed(axes)) continue;
    const std::uint64_t free = probe.steps_undisturbed(axes);
    for (const std::int32_t x : {-1, 0, 1}) {
      PlayModel::Steps moved = axes;
      moved[0] += x * static_cast<std::int32_t>(std::min<std::uint64_t>(free, 100'000));
      moved[2] -= static_cast<std::int32_t>(std::min<std::uint64_t>(free, 100'000));
      EXPECT_FALSE(free > 0 && probe.is_closed(moved)) << z << ' ' << x;
    }
  }
}

TEST(ProbeSimulator, FeelsASurfaceToTheStep) {
  for (const double tip_mm : {0.0, 1.0, 2.0}) {
    const MachineModel machine = machine_over(roof(), tip_mm);
    Simulator simulator{"G0 Z5\nG0 X4\nG38.2 Z-20 F60\n", {.machine = machine}};
    const RunResult result = simulator.run();
    EXPECT_EQ(result.alarm, 0);
    ASSERT_TRUE(simulator.machine().last_probe().success);
    const auto z_mm =
        1.0e-6 * static_cast<double>(simulator.machine().last_probe().place[2].nanometres());
    const double wanted = height_of(*machine.probe_surface, 4.0, 0.0);
    EXPECT_LE(z_mm, wanted + 1.0e-6) << tip_mm;
    EXPECT_GT(z_mm, wanted - kProbedStepMm - 1.0e-6) << tip_mm;
  }
}

TEST(ProbeSimulator, FeelsAWallOnItsWayAlong) {
  const MachineModel machine = machine_over(roof(), 2.0);
  Simulator simulator{"G0 X-8 Z-5\nG38.2 X20 F300\n", {.machine = machine}};
  EXPECT_EQ(simulator.run().alarm, 0);
  ASSERT_TRUE(simulator.machine().last_probe().success);
  const auto x_mm =
      1.0e-6 * static_cast<double>(simulator.machine().last_probe().place[0].nanometres());
  const double wanted = 5.0 - (std::sqrt(2.0) - 1.0);
  EXPECT_GE(x_mm, wanted - 1.0e-6);
  EXPECT_LT(x_mm, wanted + kProbedStepMm + 1.0e-6);
}

}  // namespace
}  // namespace sim
