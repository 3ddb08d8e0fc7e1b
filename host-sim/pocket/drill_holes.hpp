#pragma once

#include "host-sim/pocket/path_rows.hpp"

namespace sim::pocket {

/// Returns the path of a drill, in an order with short rapids. The drill makes a hole at each point
/// where `path` plunges into stock, as deep as the deepest plunge at that point. Each row is one
/// peck: it begins at the depth of the previous peck and is at most `peck_mm` deep. After each
/// peck, the drill retracts.
/// @param path plunges are elements of Use::kEntry that go straight down
/// @param peck_mm greatest depth of a peck, above 0
[[nodiscard]] PathRows drill_holes(const cnc::pocket::ToolPathView<double>& path, double peck_mm);

}  // namespace sim::pocket
