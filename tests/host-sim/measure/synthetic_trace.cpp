#include "tests/host-sim/measure/synthetic_trace.hpp"

#include <cmath>
#include <map>
#include <random>

namespace sim {
namespace {

constexpr double kScan = 20.0e-6;

long motor_place(const SyntheticMachine& machine, const Point& point, std::size_t axis) {
  return std::lround(point[axis] * machine.steps_per_mm[axis]);
}

}  // namespace

std::vector<TraceRow> SyntheticMachine::rows(const std::function<Point(double)>& course,
                                             double end_s) const {
  std::mt19937 random{seed};
  std::uniform_real_distribution<double> late{0.0, jitter_s};
  std::map<std::uint64_t, cnc::AxisArray<std::int32_t>> changes;  // Steps at each instant.
  for (std::size_t axis = 0; axis < cnc::kAxisCount; ++axis) {
    long place = 0;
    for (double time = 0.0; time < end_s; time += kScan) {
      const double until = std::min(time + kScan, end_s);
      const long next = motor_place(*this, course(until), axis);
      if (next == place) continue;
      double low = time;
      double high = until;
      while (high - low > 0.2e-9) {
        const double middle = (low + high) / 2.0;
        (motor_place(*this, course(middle), axis) == place ? low : high) = middle;
      }
      const auto instant = static_cast<std::uint64_t>(std::llround((high + late(random)) * 1.0e9));
      changes[instant][axis] += static_cast<std::int32_t>(next - place);
      place = next;
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
