#pragma once

#include <string>

#include "host-sim/import/sketch.hpp"

namespace sim::drawing {

/// Notes that a drawing of a box generator allows for a kerf by itself. Boxes.py grows its parts by
/// `burn`, half the kerf, for a beam along the drawn line; cut beside that line they are too large
/// by twice as much, and do not fit.
void note_burn(Sketch& sketch, const std::string& svg);

}  // namespace sim::drawing
