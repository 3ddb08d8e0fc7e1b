#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "host-sim/machine/program_link.hpp"
#include "host-sim/measure/programmed_path.hpp"
#include "host-sim/report/report.hpp"

namespace sim {

/// Returns the fault for a refused line of the program `text` of a file. The controller refuses an
/// offset path (G41, G42) that cannot be driven only at a line up to 16 motions later. The fault is
/// then at the line that programs the motion.
/// @param beside motion whose offset path could not be driven, if there is one; see beside_path()
[[nodiscard]] Fault fault_of(const std::string& file,
                             const Refusal& refusal,
                             const std::optional<RefusedBeside>& beside,
                             std::string_view text);

/// Returns the column, from 1, of the first word of a line after the block delete character and the
/// word N; 0 if the line has no other word.
/// @param line number of the line, from 1
[[nodiscard]] std::size_t first_word(std::string_view text, int line);

}  // namespace sim
