#pragma once

#include "host-sim/pocket/path_rows.hpp"

namespace sim::pocket {

/// Returns the path of a drill that makes a hole for each place where a path plunges into stock, to
/// the deepest of its plunges there, in an order with short rapids. Each row is one peck: from
/// where the peck before it ended, by at most `peck_mm`; the drill retracts after it.
/// @param path plunges are elements of Use::kEntry that go straight down
/// @param peck_mm above 0
[[nodiscard]] PathRows drill_holes(const cnc::pocket::ToolPathView<double>& path, double peck_mm);

}  // namespace sim::pocket
