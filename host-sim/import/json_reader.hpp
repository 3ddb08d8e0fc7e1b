#pragma once

#include <string>

#include "host-sim/import/sketch.hpp"

namespace sim::drawing {

/// Reads one of two JSON formats, both in mm:
/// - cutting layouts (DBS): `[{"partid", "paths": [[[x, y, bulge], …], …]}, …]`, where each bulge
///   belongs to the edge that begins at its vertex;
/// - nesting jobs: `{"items": [{"id", "shape": {"type": "simple_polygon", "data": [[x, y], …]}},
///   …]}`, where each item is drawn once, at the coordinates of its data.
///
/// Faults give the position in the file as a JSON pointer.
void read_json(const std::string& text, Sketch& sketch);

}  // namespace sim::drawing
