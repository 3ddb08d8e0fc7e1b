#include "tests/simulation/jerk_check.hpp"

#include <cmath>

namespace proof {
namespace {

/// A cell of one acceleration: so many slices.
struct Cell {
  std::size_t first = 0;
  std::size_t end = 0;
  double acceleration = 0.0;
  double seconds = 0.0;
};

Cell cell_at(const RecordedPlan& plan, std::size_t first) {
  const auto acceleration_of = [&](std::size_t slice) {
    return plan.slices[slice].slice.acceleration;
  };
  Cell cell{
      .first = first, .end = first, .acceleration = static_cast<double>(acceleration_of(first))};
  while (cell.end < plan.slices.size() && acceleration_of(cell.end) == acceleration_of(first)) {
    cell.seconds += static_cast<double>(plan.slices[cell.end].slice.duration);
    ++cell.end;
  }
  return cell;
}

/// t″: of an arc −κ² t; of a helix only what of the tangent lies in the plane turns.
Vector bend_rate_of(const ExactBlock& block, const Vector& tangent, const Vector& bend) {
  Vector rate{};
  if (!block.turns()) return rate;
  const cnc::PlaneAxes axes = block.plane();
  const double share = std::hypot(tangent[axes.first], tangent[axes.second]);
  const double turn = norm(bend) / share;  // Radians per mm of path.
  for (const std::size_t axis : {axes.first, axes.second})
    rate[axis] = -turn * turn * tangent[axis];
  return rate;
}

/// Shorter cells are the ends of motions, of which rounding makes too much.
constexpr double kShortest = 20.0e-6;

}  // namespace

Greatest greatest_jerk(const RecordedPlan& plan, const TestMachine& machine) {
  Greatest greatest;
  Cell before;
  for (std::size_t first = 0; first < plan.slices.size();) {
    const Cell cell = cell_at(plan, first);
    first = cell.end;
    // From rest on acceleration begins at nothing.
    if (plan.slices[cell.first].slice.start_speed <= 0.0F) before = {};
    const double time = 0.5 * (cell.seconds + before.seconds);
    const double along = (cell.acceleration - before.acceleration) / time;
    const double mean = 0.5 * (cell.acceleration + before.acceleration);
    before = cell;
    if (cell.seconds < kShortest) continue;

    const std::size_t middle = (cell.first + cell.end) / 2;
    const TimedSlice& slice = plan.slices[middle];
    const double half = 0.5 * static_cast<double>(slice.slice.duration);
    const double speed = slice.speed_at(half);
    const ExactBlock& block = plan.blocks[slice.slice.block].exact;
    const Vector tangent = block.tangent_at(slice.fraction_at(half));
    const Vector bend = block.bend_at(slice.fraction_at(half));
    const Vector bend_rate = bend_rate_of(block, tangent, bend);
    for (std::size_t axis = 0; axis < cnc::kAxisCount; ++axis) {
      const double jerk = tangent[axis] * along + 3.0 * bend[axis] * speed * mean +
                          bend_rate[axis] * std::pow(speed, 3);
      const auto limit = static_cast<double>(machine.limits.jerk_mm_s3[axis]);
      greatest.note(std::abs(jerk) / limit, middle, axis);
    }
  }
  return greatest;
}

}  // namespace proof
