#pragma once

#include "planner/gcode/modal_state.hpp"
#include "planner/gcode/options.hpp"
#include "planner/kerf/kerf_table.hpp"

namespace cnc::gcode {

/// Returns the condition of the cut: its thickness, power and speed according to the present M190,
/// S and F.
/// @pre the options have a kerf table and the greatest power
[[nodiscard]] kerf::Condition kerf_condition(const ModalState& modal, const Options& options);

}  // namespace cnc::gcode
