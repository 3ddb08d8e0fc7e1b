#pragma once

#include "host-sim/measure/programmed_path.hpp"
#include "planner/path/path_item.hpp"

namespace sim {

/// Returns a path element of the product as a piece in double precision.
[[nodiscard]] PathPiece piece_of(const cnc::PathElement& element,
                                 float feed_mm_s,
                                 bool stop_before);
/// Sets the beam of a piece to a command from item_of().
void set_beam(PathPiece& piece, const cnc::motion::BeamCommand& beam);

/// Returns a piece in the product's form: element, feed, beam, tolerance and line.
[[nodiscard]] cnc::path::PathItem item_of(const PathPiece& piece);

}  // namespace sim
