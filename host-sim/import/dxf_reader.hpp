#pragma once

#include <optional>
#include <string>

#include "host-sim/import/sketch.hpp"

namespace sim::drawing {

/// Reads a DXF file of Release 12 to 2018, in ASCII or binary, and converts its unit ($INSUNITS) to
/// mm. Reads LINE, ARC, CIRCLE, LWPOLYLINE, POLYLINE, ELLIPSE, SPLINE, HELIX and the outlines of
/// 3DFACE, SOLID and TRACE in model space, and the blocks that INSERTs repeat.
///
/// Tilted entities are drawn as they appear from above, with a note. Annotations are left out with
/// a note, and so are invisible entities and entities on layers that are off, frozen or not
/// plotted. Letters are drawn in the text mode of the sketch. Other entities that draw lines are
/// faults, and so are INSERTs with boundaries that are not supported. Messages give the lines of
/// the file; for a binary file, the lines of the same file in ASCII.
/// @param mm_per_unit replaces $INSUNITS; above 0
/// @return millimetres per unit of the drawing
double read_dxf(const std::string& text, Sketch& sketch, std::optional<double> mm_per_unit = {});

}  // namespace sim::drawing
