#pragma once

#include <cstddef>
#include <optional>
#include <string_view>
#include <vector>

#include "host-sim/machine/program_link.hpp"
#include "host-sim/plot/path.hpp"
#include "planner/gcode/interpreter.hpp"

namespace sim {

/// The path of a program that has not run, seen from above. For drawing only:
/// it is some hundredths of a millimetre wide, or coarser where it is long.
struct ProgramOutline {
  std::vector<PathVertex> vertices;  ///< Machine coordinates; speeds are not known.
  std::optional<Refusal> refused;    ///< The outline ends before this line.
};

/// Points that an outline is thinned from: more than any job that people make,
/// and read within seconds. A line that asks for more is refused.
inline constexpr std::size_t kMostOutlinePoints = 20'000'000;

/// Reads a program as the controller would now: `reader` is the controller's own,
/// with its place, offsets and modes. The answer begins at that place.
///
/// Lines of `$` are no G-code and passed over; the contact of a probe is taken as
/// programmed; M2 and M30 do not end it, as they do not end what a sender sends.
[[nodiscard]] ProgramOutline program_outline_of(std::string_view program,
                                                cnc::gcode::Interpreter reader,
                                                std::size_t most_points = kMostOutlinePoints);

}  // namespace sim
