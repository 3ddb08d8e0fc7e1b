#include "tests/simulation/jerk_check.hpp"

#include <cmath>

namespace proof {
namespace {

/// A cell: successive slices with one acceleration, which is the mean acceleration over the cell.
struct Cell {
  std::size_t first = 0;
  std::size_t end = 0;
  double start_s = 0.0;
  double seconds = 0.0;
  double acceleration = 0.0;

  [[nodiscard]] double middle_s() const { return start_s + 0.5 * seconds; }
};

/// Returns the cell that begins at slice `first`. @param longest_s longest duration of a cell,
/// which divides a run of cells with equal acceleration
Cell cell_at(const RecordedPlan& plan, std::size_t first, double longest_s) {
  const auto acceleration_of = [&](std::size_t slice) {
    return plan.slices[slice].slice.acceleration;
  };
  constexpr double kRounded = 1.001;
  Cell cell{.first = first,
            .end = first,
            .start_s = plan.slices[first].start_s,
            .acceleration = static_cast<double>(acceleration_of(first))};
  while (cell.end < plan.slices.size() && acceleration_of(cell.end) == acceleration_of(first)) {
    const auto duration = static_cast<double>(plan.slices[cell.end].slice.duration);
    if (cell.seconds + duration > longest_s * kRounded) break;
    cell.seconds += duration;
    ++cell.end;
  }
  return cell;
}

/// Returns t″: −κ² t on an arc; on a helix only the part of the tangent in the plane counts.
Vector bend_rate_of(const ExactBlock& block, const Vector& tangent, const Vector& bend) {
  Vector rate{};
  if (!block.turns()) return rate;
  rate = block.in_plane(tangent);
  const double turn = norm(bend) / norm(rate);  // Turn of the tangent, radians per mm of path.
  for (double& share : rate) share *= -turn * turn;
  return rate;
}

/// Shortest duration of a cell that is judged, s. Shorter cells occur at the ends of motions, where
/// rounding has too much effect.
constexpr double kShortest = 20.0e-6;

/// The acceleration along the path as a line between the middles of two cells.
struct Ramp {
  double from_s = 0.0;
  double acceleration = 0.0;
  double jerk = 0.0;

  Ramp(const Cell& before, const Cell& behind)
      : from_s{before.middle_s()},
        acceleration{before.acceleration},
        jerk{(behind.acceleration - before.acceleration) /
             (behind.middle_s() - before.middle_s())} {}
};

class JerkCheck {
 public:
  JerkCheck(const RecordedPlan& plan, const TestMachine& machine)
      : plan_{plan}, limits_{machine.limits} {}

  Greatest run() {
    Cell before;
    Cell cell;
    double longest_s = 0.0;
    for (std::size_t first = 0; first < plan_.slices.size(); first = cell.end) {
      const bool from_rest = plan_.slices[first].slice.start_speed <= 0.0F;
      if (from_rest) longest_s = INFINITY;
      cell = cell_at(plan_, first, longest_s);
      if (from_rest) {
        longest_s = cell.seconds;
        // The acceleration rises from 0.
        before = {.start_s = cell.start_s};
      }
      if (cell.seconds >= kShortest) {
        look_at(before, cell, before);
        look_at(before, cell, cell);
      }
      before = cell;
    }
    return greatest_;
  }

 private:
  /// Checks those slices of `within` that lie between the middles of two cells.
  void look_at(const Cell& before, const Cell& behind, const Cell& within) {
    const Ramp ramp{before, behind};
    for (std::size_t i = within.first; i < within.end; ++i) {
      const TimedSlice& slice = plan_.slices[i];
      const double half = 0.5 * static_cast<double>(slice.slice.duration);
      const double time = slice.start_s + half;
      if (time >= before.middle_s() && time <= behind.middle_s()) look_at(ramp, i, half);
    }
  }

  void look_at(const Ramp& ramp, std::size_t index, double within) {
    const TimedSlice& slice = plan_.slices[index];
    const double speed = slice.speed_at(within);
    const double along = ramp.acceleration + ramp.jerk * (slice.start_s + within - ramp.from_s);
    const ExactBlock& block = plan_.blocks[slice.slice.block].exact;
    const Vector tangent = block.tangent_at(slice.fraction_at(within));
    const Vector bend = block.bend_at(slice.fraction_at(within));
    const Vector bend_rate = bend_rate_of(block, tangent, bend);
    for (std::size_t axis = 0; axis < cnc::kAxisCount; ++axis) {
      const double jerk = tangent[axis] * ramp.jerk + 3.0 * bend[axis] * speed * along +
                          bend_rate[axis] * std::pow(speed, 3);
      const auto limit = static_cast<double>(limits_.jerk_mm_s3[axis]);
      greatest_.note(std::abs(jerk) / limit, index, axis);
    }
  }

  const RecordedPlan& plan_;
  const cnc::motion::Limits& limits_;
  Greatest greatest_{};
};

}  // namespace

Greatest greatest_jerk(const RecordedPlan& plan, const TestMachine& machine) {
  return JerkCheck{plan, machine}.run();
}

}  // namespace proof
