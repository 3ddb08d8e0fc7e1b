#pragma once

#include "host-sim/plot/space/hidden_lines.hpp"
#include "host-sim/surface/path/surface_path.hpp"

namespace sim::surface {

/// Returns the way of the tip over a stretch as points in space, between which chords leave its
/// arcs by no more than `chord_mm`, above 0.
[[nodiscard]] SpaceLine line_of(const SurfaceStretch& stretch, double chord_mm);

}  // namespace sim::surface
