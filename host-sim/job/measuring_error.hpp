#pragma once

#include "firmware/machine/settings.hpp"
#include "host-sim/report/report.hpp"

namespace sim {

/// Fills in the errors that measuring on steps may cause, for each axis's greatest speed,
/// acceleration and jerk and for its bounds.
void add_measuring_errors(const cnc::Settings& settings, Report& report);

}  // namespace sim
