#pragma once

#include <vector>

#include "host-sim/cut/timeline.hpp"

namespace sim::cut {

/// Time and distance in which the heat of a pierce falls to 1/e. They suffice to show where a sheet
/// of a few millimetres gets warm. Chosen for pictures; not measured on any material.
inline constexpr double kHeatFadesInS = 10.0;
inline constexpr double kHeatFadesInMm = 10.0;

/// Returns for each cut how warm the sheet is at its pierce: the sum over all earlier cuts of
/// exp(−t / 10 s) · exp(−(d / 10 mm)²), with the time t and the distance d between the pierces. 0
/// is a cold sheet. 1 means the warmth of a point where another hole has just been pierced.
[[nodiscard]] std::vector<double> heat_at_pierces(const CutPlan& plan, const Timeline& timeline);

}  // namespace sim::cut
