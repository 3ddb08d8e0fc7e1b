#pragma once

#include "host-sim/plot/space/hidden_lines.hpp"
#include "host-sim/surface/path/surface_path.hpp"

namespace sim::surface {

/// Returns the path of the tip over a stretch as points in space. The deviation of chords between
/// the points from the stretch's arcs is at most `chord_mm`, > 0.
[[nodiscard]] SpaceLine line_of(const SurfaceStretch& stretch, double chord_mm);

}  // namespace sim::surface
