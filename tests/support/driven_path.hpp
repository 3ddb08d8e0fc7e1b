#pragma once

#include "host-sim/measure/programmed_path.hpp"
#include "planner/path/path_item.hpp"

namespace proof {

/// An element for the references: its curve in double precision.
[[nodiscard]] sim::PathPiece piece_of(const cnc::PathElement& element,
                                      float feed_mm_s,
                                      bool stop_before);

/// What the product's path stage makes of a programmed path when its elements
/// come one by one without a pause: rounded, welded, with its exact stops.
[[nodiscard]] sim::ProgrammedPath driven_path(const sim::ProgrammedPath& programmed,
                                              const cnc::motion::Limits& limits,
                                              const cnc::path::Tolerance& tolerance);

}  // namespace proof
