#pragma once

#include <string>

#include "host-sim/import/sketch.hpp"

namespace sim::drawing {

/// Reads, in mm, the JSON of
/// - cutting layouts (DBS): `[{"partid", "paths": [[[x, y, bulge], …], …]}, …]`, where each bulge
///   belongs to the edge that follows;
/// - nesting jobs: `{"items": [{"id", "shape": {"type": "simple_polygon", "data": [[x, y], …]}},
///   …]}`: each item is drawn once, at its own coordinates.
///
/// Faults give the position as a JSON pointer.
void read_json(const std::string& text, Sketch& sketch);

}  // namespace sim::drawing
