#pragma once

#include <cstddef>
#include <string_view>

#include "firmware/machine/machine.hpp"
#include "firmware/protocol/reply.hpp"

namespace cnc {

/// How reports show places: `$13` and `$853`.
struct ReportForm {
  bool inches = false;
  std::size_t axes = kLinearAxisCount;  ///< From X on.
};

/// Places of all axes shown, with commas between.
void put_places(Reply& reply, const Position& place, const ReportForm& form);
/// `[GC:…]`: the modes, as words that are accepted back in one line.
void put_parser_state(Reply& reply, const Machine& machine);
/// `[PRB:x,y,z:1]`: where the probe changed last, and whether it did.
void put_probe(Reply& reply, const Probe& probe, const ReportForm& form);
/// The name in a status report.
[[nodiscard]] std::string_view name_of(MachineState state);
/// `G54`…`G59.3`
[[nodiscard]] std::string_view name_of_system(std::size_t index);

}  // namespace cnc
