#pragma once

#include <optional>
#include <string>

#include "host-sim/import/sketch.hpp"

namespace sim::drawing {

/// Reads a DXF file of Release 12 to 2018, in ASCII or binary, in mm by $INSUNITS. Reads LINE, ARC,
/// CIRCLE, LWPOLYLINE, POLYLINE, ELLIPSE, SPLINE, HELIX and the outlines of 3DFACE, SOLID and TRACE
/// of the model, and the blocks that INSERT repeats.
///
/// Tilted entities are drawn as they appear from above, with a note. Annotations are left out with
/// a note, as are entities that are invisible or on layers that are off, frozen or not plotted.
/// Letters are drawn in the text mode of the sketch. Other entities that draw lines are faults, as
/// are INSERTs with boundaries that cannot be followed. Messages give the lines of the file; for a
/// binary file, the lines that it would have in ASCII.
/// @param mm_per_unit replaces $INSUNITS; above 0
/// @return millimetres per unit of the drawing
double read_dxf(const std::string& text, Sketch& sketch, std::optional<double> mm_per_unit = {});

}  // namespace sim::drawing
