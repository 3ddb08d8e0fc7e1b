#pragma once

#include <string>

#include "host-sim/import/sketch.hpp"

namespace sim::drawing {

/// Adds a note if the drawing comes from a box generator that already allows for the kerf. Boxes.py
/// enlarges its parts on each side by `burn`, which is half of the kerf, for a beam along the drawn
/// lines. If the cut is offset from these lines as well, the parts become too large by twice `burn`
/// and do not fit.
void note_burn(Sketch& sketch, const std::string& svg);

}  // namespace sim::drawing
