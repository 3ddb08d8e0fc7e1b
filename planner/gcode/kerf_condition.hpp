#pragma once

#include "planner/gcode/modal_state.hpp"
#include "planner/gcode/options.hpp"
#include "planner/kerf/kerf_table.hpp"

namespace cnc::gcode {

/// What is cut, with which power and at which speed: M190, S and F as they are set.
/// @pre the options have a kerf source and the greatest power
[[nodiscard]] kerf::Condition kerf_condition(const ModalState& modal, const Options& options);

}  // namespace cnc::gcode
