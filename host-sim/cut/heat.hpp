#pragma once

#include <vector>

#include "host-sim/cut/timeline.hpp"

namespace sim::cut {

/// Heat of a pierce fades to 1/e within this time and within this distance: enough to show where a
/// sheet of a few millimetres gets warm. Chosen for pictures; no material is behind it.
inline constexpr double kHeatFadesInS = 10.0;
inline constexpr double kHeatFadesInMm = 10.0;

/// Returns for each cut how warm the sheet is where it is pierced: the sum over the cuts before it
/// of exp(−t / 10 s) · exp(−(d / 10 mm)²), by the time and the distance between the pierces. 0 is a
/// cold sheet; 1 means as if another hole had just been pierced there.
[[nodiscard]] std::vector<double> heat_at_pierces(const CutPlan& plan, const Timeline& timeline);

}  // namespace sim::cut
