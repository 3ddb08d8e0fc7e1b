#pragma once

#include <string>

#include "host-sim/import/sketch.hpp"

namespace sim::drawing {

/// Reads a DXF file in ASCII: LINE, ARC, CIRCLE, LWPOLYLINE, POLYLINE, ELLIPSE and
/// SPLINE of the model, and the blocks that INSERT repeats, in mm by $INSUNITS.
///
/// Of entities seen from behind (extrusion 0 0 -1) the mirror image; tilted ones
/// are left out. Letters are refused, everything else is named and ignored, as are
/// layers that are off or frozen.
void read_dxf(const std::string& text, Sketch& sketch);

}  // namespace sim::drawing
