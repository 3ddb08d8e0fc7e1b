#pragma once

#include <vector>

#include "host-sim/cut/timeline.hpp"

namespace sim::cut {

/// Time and distance after which the heat of a pierce has fallen to 1/e. The values are chosen for
/// pictures that show where a sheet of a few millimetres gets warm. They are not measured on any
/// material.
inline constexpr double kHeatFadesInS = 10.0;
inline constexpr double kHeatFadesInMm = 10.0;

/// Returns, for each cut, the heat of the sheet at its pierce. It is the sum over all earlier
/// pierces of exp(−t / 10 s) · exp(−(d / 10 mm)²), with the time t and the distance d between the
/// pierces. 0 is a cold sheet. 1 is the heat of a point where another hole has just been pierced.
[[nodiscard]] std::vector<double> heat_at_pierces(const CutPlan& plan, const Timeline& timeline);

}  // namespace sim::cut
