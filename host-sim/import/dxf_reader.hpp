#pragma once

#include <optional>
#include <string>

#include "host-sim/import/sketch.hpp"

namespace sim::drawing {

/// Reads a DXF file of Release 12 to 2018, in ASCII or binary: LINE, ARC, CIRCLE, LWPOLYLINE,
/// POLYLINE, ELLIPSE, SPLINE, HELIX and the outlines of 3DFACE, SOLID and TRACE of the model, and
/// the blocks that INSERT repeats, in mm by $INSUNITS.
///
/// Tilted entities are drawn as they are seen from above, with a note. Letters and annotations are
/// left out with a note, as is what is invisible or on layers that are off, frozen or not plotted.
/// What draws lines in another way, and a clipped INSERT, is a fault. Lines of messages are those
/// of the file; of a binary one, those that it has in ASCII.
/// @param mm_per_unit in place of $INSUNITS; above 0
/// @return millimetres per unit of the drawing
double read_dxf(const std::string& text, Sketch& sketch, std::optional<double> mm_per_unit = {});

}  // namespace sim::drawing
