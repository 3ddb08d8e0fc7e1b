#include "tests/support/jerk_time.hpp"

#include <algorithm>
#include <cmath>

#include "tests/support/speed_problem.hpp"

namespace sim {
namespace {

/// Duality gap at which the search ends, as a share of the time.
constexpr double kGap = 2.0e-4;
constexpr double kWeightGrowth = 10.0;
constexpr int kMaxSteps = 200;

struct Descent {
  std::vector<double> unknown;
  double gap = 0.0;  ///< Duality gap, s.
  int steps = 0;
};

/// Minimizes the barrier function at one weight by Newton's method, until the decrement is small.
void centre(const SpeedProblem& problem, double weight, double tolerance, Descent& descent) {
  BandSystem system{problem.unknowns()};
  double value = problem.value(descent.unknown, weight);
  for (int step = 0; step < kMaxSteps; ++step, ++descent.steps) {
    problem.derive(descent.unknown, weight, system);
    const std::vector<double> right = system.right();
    const std::vector<double> direction = system.solve();
    double decrement = 0.0;
    for (std::size_t i = 0; i < right.size(); ++i) decrement += right[i] * direction[i];
    if (!(decrement > 2.0 * tolerance)) return;
    double length = 1.0;
    for (;; length *= 0.5) {
      if (length < 1.0e-9) return;
      std::vector<double> next = descent.unknown;
      for (std::size_t i = 0; i < next.size(); ++i) next[i] += length * direction[i];
      const double reached = problem.value(next, weight);
      if (reached > value - 0.1 * length * decrement) continue;
      descent.unknown = std::move(next);
      value = reached;
      break;
    }
  }
}

Descent solve(const SpeedProblem& problem, double start) {
  Descent descent{.unknown = problem.slow_start(start)};
  const double rules = problem.rule_count();
  double weight = rules / problem.time(descent.unknown);
  for (;;) {
    const bool last = rules / weight <= kGap * problem.time(descent.unknown);
    centre(problem, weight, last ? 1.0e-3 : 1.0e-3 * rules, descent);
    descent.gap = rules / weight;
    if (last) return descent;
    weight *= kWeightGrowth;
  }
}

}  // namespace

JerkLimitedTime jerk_limited_time(const ProgrammedPath& path,
                                  const MotionLimits& limits,
                                  const MeshSize& size) {
  JerkLimitedTime time;
  for (const SpeedSection& section : speed_mesh(path, limits, size)) {
    const SpeedProblem exact{section, true};
    const Descent found = solve(exact, size.start);
    time.found += exact.time(found.unknown);
    const SpeedProblem relaxed{section, false};
    const Descent bound = solve(relaxed, size.start);
    time.bound += relaxed.time(bound.unknown) - bound.gap;
    time.cells += section.size();
  }
  return time;
}

std::vector<JerkSample> jerk_limited_profile(const ProgrammedPath& path,
                                             const MotionLimits& limits,
                                             const MeshSize& size) {
  std::vector<JerkSample> samples{{}};
  for (const SpeedSection& section : speed_mesh(path, limits, size)) {
    const SpeedProblem exact{section, true};
    const Descent found = solve(exact, size.start);
    for (std::size_t i = 0; i < section.size(); ++i) {
      const double place = samples.back().place + section[i].length;
      const auto [y, first] = exact.end_of(i, found.unknown);
      const double speed = std::cbrt(std::max(0.0, y));
      samples.push_back({place, speed, speed > 0.0 ? first / (3.0 * speed) : 0.0});
    }
  }
  return samples;
}

}  // namespace sim
