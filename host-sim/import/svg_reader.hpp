#pragma once

#include <string>

#include "host-sim/import/sketch.hpp"

namespace sim::drawing {

/// Reads an SVG document: what is drawn of it, in mm at 96 px to the inch, with y
/// turned up, so that the lower left corner of its viewport is the origin.
///
/// Paths, basic shapes, groups, links, nested documents, `use`, `symbol` and `switch`; style
/// sheets, entities of the DOCTYPE, and clip paths, within or outside of which a shape has to lie.
/// Masks, filters, markers and patterns are named and ignored; letters become what the sketch
/// wishes, images are kept as pictures. What cannot be read is left out, and a fault says so.
void read_svg(const std::string& text, Sketch& sketch);

}  // namespace sim::drawing
