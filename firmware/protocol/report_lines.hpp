#pragma once

#include <cstddef>
#include <string_view>

#include "firmware/machine/machine.hpp"
#include "firmware/protocol/reply.hpp"

namespace cnc {

/// Form of positions in reports, from the settings `$13` and `$853`.
struct ReportForm {
  bool inches = false;
  std::size_t axes = kLinearAxisCount;  ///< Number of reported axes, from X on.
};

/// Writes the positions of all reported axes, separated by commas.
void put_places(Reply& reply, const Position& place, const ReportForm& form);
/// Writes `[GC:…]`: the modes, as words that the controller accepts in one line.
void put_parser_state(Reply& reply, const Machine& machine);
/// Writes `[PRB:x,y,z:1]`: the position at which the probe last changed, and 1 or 0 for success.
void put_probe(Reply& reply, const Probe& probe, const ReportForm& form);
/// Returns the name of a state as in a status report.
[[nodiscard]] std::string_view name_of(MachineState state);
/// Returns the name of a coordinate system, `G54` to `G59.3`, by its index from 0.
[[nodiscard]] std::string_view name_of_system(std::size_t index);

}  // namespace cnc
