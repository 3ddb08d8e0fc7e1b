#pragma once

#include "firmware/machine/settings.hpp"
#include "host-sim/report/report.hpp"

namespace sim {

/// Fills in by how much each axis's greatest speed, acceleration and jerk, and its bounds, may be
/// off because they are measured on steps.
void add_measuring_errors(const cnc::Settings& settings, Report& report);

}  // namespace sim
