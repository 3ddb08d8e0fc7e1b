#pragma once

#include "host-sim/plot/space/hidden_lines.hpp"
#include "host-sim/surface/path/surface_path.hpp"

namespace sim::surface {

/// Returns the path of the tip over a stretch as points in space. Chords between the points leave
/// the stretch's arcs by at most `chord_mm`, above 0.
[[nodiscard]] SpaceLine line_of(const SurfaceStretch& stretch, double chord_mm);

}  // namespace sim::surface
