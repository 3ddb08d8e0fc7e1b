#pragma once

#include "host-sim/pocket/path_rows.hpp"

namespace sim::pocket {

/// Returns the path of a drill, in an order with short rapids. It makes a hole at each point where
/// a path plunges into stock, as deep as the deepest plunge there. Each row is one peck: it begins
/// at the end of the previous peck and is at most `peck_mm` deep. The drill retracts after it.
/// @param path plunges are elements of Use::kEntry that go straight down
/// @param peck_mm above 0
[[nodiscard]] PathRows drill_holes(const cnc::pocket::ToolPathView<double>& path, double peck_mm);

}  // namespace sim::pocket
