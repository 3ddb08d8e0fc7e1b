#include "tests/host-sim/measure/synthetic_trace.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <random>

namespace sim {
namespace {

constexpr double kScan = 20.0e-6;

long motor_place(const SyntheticMachine& machine, const Point& point, std::size_t axis) {
  return std::lround(point[axis] * machine.steps_per_mm[axis]);
}

/// Returns the time at which the motor leaves this step, within one scan interval before `until`,
/// to 0.2 ns.
double crossing(const SyntheticMachine& machine,
                const std::function<Point(double)>& course,
                std::size_t axis,
                long place,
                double until) {
  double low = std::max(0.0, until - kScan);
  double high = until;
  while (high - low > 0.2e-9) {
    const double middle = (low + high) / 2.0;
    (motor_place(machine, course(middle), axis) == place ? low : high) = middle;
  }
  return high;
}

}  // namespace

std::vector<TraceRow> SyntheticMachine::rows(const std::function<Point(double)>& course,
                                             double end_s) const {
  std::mt19937 random{seed};
  std::uniform_real_distribution<double> late{0.0, jitter_s};
  std::map<std::uint64_t, cnc::AxisArray<std::int32_t>> changes;  // Steps at each time.
  cnc::AxisArray<long> places{};
  const long scans = std::lround(std::ceil(end_s / kScan));
  for (long scan = 1; scan <= scans; ++scan) {
    const double until = std::min(static_cast<double>(scan) * kScan, end_s);
    const Point point = course(until);
    for (std::size_t axis = 0; axis < cnc::kAxisCount; ++axis) {
      const long next = motor_place(*this, point, axis);
      if (next == places[axis]) continue;
      const double time = crossing(*this, course, axis, places[axis], until) + late(random);
      changes[static_cast<std::uint64_t>(std::llround(time * 1.0e9))][axis] +=
          static_cast<std::int32_t>(next - places[axis]);
      places[axis] = next;
    }
  }
  std::vector<TraceRow> rows;
  TraceRow row;
  for (const auto& [instant, steps] : changes) {
    row.time_ns = instant;
    for (std::size_t axis = 0; axis < steps.size(); ++axis) row.position[axis] += steps[axis];
    rows.push_back(row);
  }
  return rows;
}

void play(const std::vector<TraceRow>& rows, TraceSink& sink) {
  for (const TraceRow& row : rows) sink.on_row(row);
  sink.on_end(rows.empty() ? 0 : rows.back().time_ns);
}

}  // namespace sim
