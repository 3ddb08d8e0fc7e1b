#pragma once

#include <string>

#include "host-sim/import/sketch.hpp"

namespace sim::drawing {

/// Reads an SVG document, in mm at 96 px to the inch. The y axis is turned upwards, so that the
/// lower left corner of the viewport is the origin.
///
/// Supports paths, basic shapes, groups, links, nested documents, `use`, `symbol` and `switch`, as
/// well as style sheets, entities of the DOCTYPE, and clip paths. A shape must be completely inside
/// or completely outside of a clip path. Masks, filters, markers and patterns are ignored with a
/// note. Letters are drawn in the text mode of the sketch, and images become pictures. Content that
/// cannot be read is left out, and a fault reports it.
void read_svg(const std::string& text, Sketch& sketch);

}  // namespace sim::drawing
