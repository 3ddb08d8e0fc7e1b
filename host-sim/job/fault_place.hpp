#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "host-sim/machine/program_link.hpp"
#include "host-sim/measure/programmed_path.hpp"
#include "host-sim/report/report.hpp"

namespace sim {

/// Returns a refused line as a fault of the program `text` in a file. If a path offset from the
/// programmed one (G41, G42) cannot be driven, the fault is at the line that programs its motion:
/// the controller refuses a line up to 16 motions later.
/// @param beside the motion that could not be driven, see beside_path()
[[nodiscard]] Fault fault_of(const std::string& file,
                             const Refusal& refusal,
                             const std::optional<RefusedBeside>& beside,
                             std::string_view text);

/// Returns the column of a line's first word after block delete and N, from 1; 0 if the line has no
/// such word.
/// @param line from 1
[[nodiscard]] std::size_t first_word(std::string_view text, int line);

}  // namespace sim
