#include "host-sim/job/measuring_error.hpp"

#include <cmath>

#include "host-sim/job/axis_scale.hpp"
#include "host-sim/measure/motion_meter.hpp"

namespace sim {
namespace {

/// Returns the greatest error of a derivative of the position that an error `edge_s` of the times
/// of pulse edges causes. DifferenceMeter gives the formula.
double error_of_order(int order, double speed, double edge_s, double window_s) {
  return std::pow(2.0 / window_s, order) * speed * edge_s;
}

}  // namespace

void add_measuring_errors(const cnc::Settings& settings, Report& report) {
  constexpr double kSecondsPerMicrosecond = 1.0e-6;
  constexpr double kTickS = 250.0e-9;
  const MeterWindows windows;
  // A pulse and an equally long pause after it are a slot. A pulse may be late by this slot and by
  // a tick of the timer.
  const double pulse_us = settings.get(cnc::setting::kStepPulse);
  const double edge_s = 2.0 * pulse_us * kSecondsPerMicrosecond + kTickS;
  const auto steps = steps_per_mm<double>(settings);
  for (std::size_t i = 0; i < cnc::kAxisCount; ++i) {
    AxisReport& axis = report.axes[i];
    const double speed = axis.max_speed_mm_s;
    axis.speed_error_mm_s = error_of_order(1, speed, edge_s, windows.speed_s);
    axis.acceleration_error_mm_s2 = error_of_order(2, speed, edge_s, windows.acceleration_s);
    axis.jerk_error_mm_s3 = error_of_order(3, speed, edge_s, windows.jerk_s);
    axis.bounds_error_mm = axis.steps == 0 ? 0.0 : 0.5 / steps[i];
  }
}

}  // namespace sim
