#pragma once

#include <string>

#include "planner/base/coordinate.hpp"
#include "planner/gcode/modal_state.hpp"

namespace sim {

/// Returns a length in mm as an exact decimal number for G-code.
[[nodiscard]] std::string coordinate_text(cnc::Coordinate place);

/// Returns the words for coordinate system, plane, arc distance mode and path mode. Tolerances of
/// G64 are in mm, so the line must be read in mm.
[[nodiscard]] std::string modes_of(const cnc::gcode::ModalState& state);
/// Returns the words for feed, output, coolant, and G0 or G1. The feed is in mm, so the line must
/// be read in mm.
[[nodiscard]] std::string process_of(const cnc::gcode::ModalState& state);
/// Returns the words for the units, the distance mode and the feed mode.
[[nodiscard]] std::string units_of(const cnc::gcode::ModalState& state);

}  // namespace sim
