#pragma once

#include <string>

#include "planner/base/coordinate.hpp"
#include "planner/gcode/modal_state.hpp"

namespace sim {

/// Returns a length as an exact number of G-code in mm.
[[nodiscard]] std::string coordinate_text(cnc::Coordinate place);

/// Returns words of G-code that bring a reader into a modal state: the modes whose words mean the
/// same in all units.
[[nodiscard]] std::string modes_of(const cnc::gcode::ModalState& state);
/// Returns the words for feed, output, coolant, and G0 or G1, for a line in mm.
[[nodiscard]] std::string process_of(const cnc::gcode::ModalState& state);
/// Returns the words for units, distance and feed mode.
[[nodiscard]] std::string units_of(const cnc::gcode::ModalState& state);

}  // namespace sim
