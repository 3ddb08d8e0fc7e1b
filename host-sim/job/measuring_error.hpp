#pragma once

#include "firmware/machine/settings.hpp"
#include "host-sim/report/report.hpp"

namespace sim {

/// Sets, for each axis of a report, the greatest errors of speed, acceleration, jerk and bounds
/// that result from measuring on step pulses.
void add_measuring_errors(const cnc::Settings& settings, Report& report);

}  // namespace sim
