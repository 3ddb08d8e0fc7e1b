#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "host-sim/machine/program_link.hpp"
#include "host-sim/measure/programmed_path.hpp"
#include "host-sim/report/report.hpp"

namespace sim {

/// A refused line as a fault of the program `text` in a file. A path that cannot be driven beside
/// the programmed one (G41, G42) is at fault where its motion is programmed: the line that was
/// refused comes up to 16 motions later.
/// @param beside the motion that could not be driven, see beside_path()
[[nodiscard]] Fault fault_of(const std::string& file,
                             const Refusal& refusal,
                             const std::optional<RefusedBeside>& beside,
                             std::string_view text);

/// Column of a line's first word behind block delete and N, from 1; 0 if there is none.
/// @param line from 1
[[nodiscard]] std::size_t first_word(std::string_view text, int line);

}  // namespace sim
