#pragma once

#include <string>

#include "host-sim/import/sketch.hpp"

namespace sim::drawing {

/// Adds a note if the drawing comes from a box generator that already allows for the kerf. Boxes.py
/// enlarges its parts by `burn`, half the kerf, for a beam along the drawn line. If the cut is
/// offset from that line as well, the parts are too large by twice `burn` and do not fit.
void note_burn(Sketch& sketch, const std::string& svg);

}  // namespace sim::drawing
