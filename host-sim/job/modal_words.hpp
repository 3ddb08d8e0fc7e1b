#pragma once

#include <string>

#include "planner/base/coordinate.hpp"
#include "planner/gcode/modal_state.hpp"

namespace sim {

/// A number of G-code in mm, exact.
[[nodiscard]] std::string coordinate_text(cnc::Coordinate place);

/// Words of G-code that bring a reader into a modal state: modes whose words mean the same in all
/// units.
[[nodiscard]] std::string modes_of(const cnc::gcode::ModalState& state);
/// Feed, output, coolant, and G0 or G1, for a line in mm.
[[nodiscard]] std::string process_of(const cnc::gcode::ModalState& state);
/// Units, distance and feed mode.
[[nodiscard]] std::string units_of(const cnc::gcode::ModalState& state);

}  // namespace sim
