#include "tests/support/bench_jobs.hpp"

#include <fmt/format.h>

#include <cmath>

namespace cnc::test {

std::string freeform_job(int lines) {
  constexpr double kStep = 0.1;  // mm
  std::string text = "G21 G90 G1 F6000\n";
  double x = 100.0;
  double y = 100.0;
  for (int i = 0; i < lines; ++i) {
    const double s = kStep * i;
    // The direction swings and drifts; the radius of curvature is never below 5 mm.
    const double angle = 1.5 * std::sin(s / 9.0) + 0.8 * std::sin(s / 31.0) + s / 40.0;
    x += kStep * std::cos(angle);
    y += kStep * std::sin(angle);
    text += fmt::format("X{:.3f} Y{:.3f}\n", x, y);
  }
  return text;
}

std::string arc_job(int arcs) {
  std::string text = "G21 G90 G1 F6000\n";
  double x = 0.0;
  double y = 0.0;
  // A wave of quarter circles, tangent at every joint: up and over (two clockwise), then down and
  // under (two counter-clockwise).
  for (int i = 0; i < arcs; ++i) {
    const double r = 2.0 + 0.1 * (i / 4 % 31);
    const bool clockwise = i % 4 < 2;
    const bool starts_upright = i % 2 == 0;
    const double rise = clockwise == starts_upright ? r : -r;
    const double centre_i = starts_upright ? r : 0.0;
    const double centre_j = starts_upright ? 0.0 : rise;
    x += r;
    y += rise;
    text += fmt::format(
        "G{} X{:.3f} Y{:.3f} I{:.3f} J{:.3f}\n", clockwise ? 2 : 3, x, y, centre_i, centre_j);
  }
  return text;
}

}  // namespace cnc::test
