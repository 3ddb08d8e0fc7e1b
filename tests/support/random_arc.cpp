#include "tests/support/random_arc.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "host-sim/measure/programmed_arc.hpp"
#include "tests/support/exact_block.hpp"

namespace proof {
namespace {

sim::ProgrammedArc programmed(const cnc::CentreArc& arc) {
  return {.start = to_mm(arc.start),
          .end = to_mm(arc.end),
          .plane = arc.plane,
          .centre = {static_cast<double>(arc.centre[0].nanometres()) * 1.0e-6,
                     static_cast<double>(arc.centre[1].nanometres()) * 1.0e-6},
          .clockwise = arc.clockwise,
          .turns = arc.turns};
}

cnc::Coordinate on_grid(double mm, std::int64_t grid_nm) {
  return cnc::Coordinate{std::llround(mm * 1.0e6 / static_cast<double>(grid_nm)) * grid_nm};
}

double random_sweep(Random& random) {
  switch (random.below(6)) {
    case 0:
      return random.magnitude(1.0e-4, 0.2);
    case 1:
      return std::numbers::pi;
    case 2:
      return 2.0 * std::numbers::pi;
    case 3:
      return 2.0 * std::numbers::pi * random.between(1.0, 5.0);
    case 4:
      return 0.5 * std::numbers::pi * static_cast<double>(1 + random.below(6));
    default:
      return random.between(0.01, 2.0 * std::numbers::pi);
  }
}

/// Adds a motion off the plane: a rise along the arc, sometimes with a rotary axis.
void rise(Random& random, const TestArc& test, std::int64_t grid, cnc::CentreArc& arc) {
  const double length = test.radius * test.sweep;
  const std::size_t normal = cnc::axes_of(arc.plane).normal;
  if (random.chance(0.5)) {
    arc.end[normal] += on_grid(random.signed_magnitude(1.0e-3, 1.0) * length, grid);
  }
  if (random.chance(0.15)) {
    arc.end[3 + random.below(3)] += on_grid(random.signed_magnitude(1.0e-3, 1.0) * length, grid);
  }
}

}  // namespace

sim::ProgrammedPath exact_path(const cnc::CentreArc& arc) {
  sim::ProgrammedPath path;
  path.start = to_mm(arc.start);
  path.end = to_mm(arc.end);
  for (const sim::Curve& curve : sim::pieces_of(programmed(arc))) {
    path.pieces.push_back({.curve = curve, .travel = sim::Travel::kFeed});
  }
  return path;
}

std::size_t TestArc::elements() const {
  return static_cast<std::size_t>(std::max(1.0, std::ceil(sweep / std::numbers::pi - 1.0e-6)));
}

Program TestArc::program(double feed_mm_s) const {
  Program program;
  const cnc::ArcElements divided{arc};
  for (std::uint32_t i = 0; i < divided.count(); ++i) {
    program.items.push_back(
        {.request = {.element = divided.element(i), .feed_mm_s = static_cast<float>(feed_mm_s)}});
  }
  return program;
}

TestArc random_arc(Random& random) {
  TestArc test;
  cnc::CentreArc& arc = test.arc;
  const std::int64_t grid = random.chance(0.4) ? 100 : (random.chance(0.5) ? 10 : 1);
  test.radius = random.magnitude(0.05, 2000.0);
  test.sweep = random_sweep(random);
  arc.plane = static_cast<cnc::Plane>(random.below(3));
  arc.clockwise = random.chance(0.5);
  const cnc::PlaneAxes axes = cnc::axes_of(arc.plane);
  const double angle = random.chance(0.3)
                           ? 0.5 * std::numbers::pi * static_cast<double>(random.below(4))
                           : random.between(0, 7);
  const cnc::Coordinate x = on_grid(test.radius * std::cos(angle), grid);
  const cnc::Coordinate y = on_grid(test.radius * std::sin(angle), grid);
  arc.centre = {-x, -y};
  const double turned = arc.clockwise ? -test.sweep : test.sweep;
  const double c = std::cos(turned);
  const double s = std::sin(turned);
  const double x_mm = static_cast<double>(x.nanometres()) * 1.0e-6;
  const double y_mm = static_cast<double>(y.nanometres()) * 1.0e-6;
  arc.end[axes.first] = on_grid(x_mm * c - y_mm * s, grid) - x;
  arc.end[axes.second] = on_grid(x_mm * s + y_mm * c, grid) - y;
  arc.turns = static_cast<std::uint16_t>(
      std::max(1.0, std::ceil(test.sweep / (2 * std::numbers::pi) - 1e-9)));
  rise(random, test, grid, arc);
  test.exact = exact_path(arc);
  test.radius = sim::start_radius(programmed(arc));
  test.sweep = std::abs(sim::sweep_of(programmed(arc)));
  return test;
}

TestMachine machine_for(Random& random, const TestArc& arc, double steps) {
  const double length = arc.exact.length();
  // The speed is such that a job takes about a second; longer jobs would only delay the test.
  const double slowest = std::min(500.0, std::max(1.0, length));
  TestMachine machine = random_machine(random,
                                       {.min_rate_mm_s = slowest,
                                        .max_rate_mm_s = 1000.0,
                                        .min_acceleration = std::max(10.0, slowest)});
  for (std::size_t axis = 0; axis < cnc::kAxisCount; ++axis) {
    const double scale = std::clamp(steps / length * random.magnitude(0.3, 3.0), 10.0, 1600.0);
    machine.limits.scale[axis] = cnc::AxisScale{static_cast<float>(scale)};
  }
  return machine;
}

}  // namespace proof
