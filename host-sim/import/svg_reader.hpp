#pragma once

#include <string>

#include "host-sim/import/sketch.hpp"

namespace sim::drawing {

/// Reads an SVG document, in mm at 96 px to the inch. The y axis is turned upwards, so that the
/// lower left corner of the viewport is the origin.
///
/// Reads paths, basic shapes, groups, links, nested documents, `use`, `symbol` and `switch`; style
/// sheets, entities of the DOCTYPE, and clip paths. A shape has to lie fully within or fully
/// outside of a clip path. Masks, filters, markers and patterns are named in notes and ignored.
/// Letters are drawn in the text mode of the sketch, and images are kept as pictures. Content that
/// cannot be read is left out, and a fault reports it.
void read_svg(const std::string& text, Sketch& sketch);

}  // namespace sim::drawing
