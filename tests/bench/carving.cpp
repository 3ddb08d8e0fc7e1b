/// Measures the path in mm/s that the simulator's carver processes, with tools of 10 mm diameter on
/// cells of 0.05 mm. The path consists of chords, as the simulator gathers its steps into chords
/// within a tolerance.
/// Run: build/release/tests/bench_carving

#include <benchmark/benchmark.h>

#include <cmath>
#include <vector>

#include "host-sim/stock/carver.hpp"

namespace {

using sim::stock::Carver;
using sim::stock::Cutter;
using sim::stock::CutterKind;
using sim::stock::Stock;
using sim::stock::Stretch;

constexpr double kCellMm = 0.05;
constexpr double kToleranceMm = 0.25 * kCellMm;

/// Returns rings of 10 to 30 mm radius around (50, 50), 5 mm deep, which descend by `fall` mm per
/// mm of path.
std::vector<Stretch> rings(double fall) {
  std::vector<Stretch> stretches;
  for (const double radius : {10.0, 20.0, 30.0}) {
    const double step = std::sqrt(8.0 * kToleranceMm / radius);
    const auto pose = [&](double angle) {
      return sim::stock::Pose{50.0 + radius * std::cos(angle),
                              50.0 + radius * std::sin(angle),
                              -5.0 - fall * radius * angle};
    };
    for (double angle = 0.0; angle < 6.28; angle += step) {
      stretches.push_back(
          {pose(angle), pose(angle + step), kToleranceMm, fall > 0.0 ? 0.1 * kToleranceMm : 0.0});
    }
  }
  return stretches;
}

void carve(benchmark::State& state, CutterKind kind, double fall) {
  const Cutter cutter{
      .kind = kind, .diameter_mm = 10.0, .corner_radius_mm = 1.0, .included_angle_deg = 90.0};
  const std::vector<Stretch> stretches = rings(fall);
  double path_mm = 0.0;
  for ([[maybe_unused]] auto _ : state) {
    Stock stock{{0.0, 0.0, 100.0, 100.0, 0.0, -20.0}, kCellMm};
    Carver carver{stock, cutter};
    for (const Stretch& stretch : stretches) {
      carver.sweep(stretch);
      path_mm +=
          std::hypot(stretch.to.x_mm - stretch.from.x_mm, stretch.to.y_mm - stretch.from.y_mm);
    }
    benchmark::DoNotOptimize(stock.removed());
  }
  state.counters["mm"] = benchmark::Counter(path_mm, benchmark::Counter::kIsRate);
}

BENCHMARK_CAPTURE(carve, flat, CutterKind::kFlat, 0.0);
BENCHMARK_CAPTURE(carve, ball, CutterKind::kBall, 0.0);
BENCHMARK_CAPTURE(carve, bull_nose, CutterKind::kBull, 0.0);
BENCHMARK_CAPTURE(carve, v, CutterKind::kV, 0.0);
BENCHMARK_CAPTURE(carve, flat_falling, CutterKind::kFlat, 0.02);
BENCHMARK_CAPTURE(carve, ball_falling, CutterKind::kBall, 0.02);
BENCHMARK_CAPTURE(carve, bull_nose_falling, CutterKind::kBull, 0.02);
BENCHMARK_CAPTURE(carve, v_falling, CutterKind::kV, 0.02);

}  // namespace
