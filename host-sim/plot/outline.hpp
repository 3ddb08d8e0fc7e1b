#pragma once

#include <cstddef>
#include <optional>
#include <string_view>
#include <vector>

#include "host-sim/machine/program_link.hpp"
#include "host-sim/plot/path.hpp"
#include "planner/gcode/interpreter.hpp"

namespace sim {

/// The path of a program that has not run, seen from above. For drawing only: the path is exact to
/// a few hundredths of a millimetre, or less exact if it is long.
struct ProgramOutline {
  std::vector<PathVertex> vertices;  ///< Points in machine coordinates; speeds are not known.
  std::optional<Refusal> refused;    ///< Line before which the outline ends, with the reason.
};

/// Greatest number of points before thinning. No job of a real user has more, and this number is
/// read within seconds. A line that needs more is refused.
inline constexpr std::size_t kMaxOutlinePoints = 20'000'000;

/// Returns the path that a program would take if the controller read it now. The path begins at the
/// controller's position.
///
/// Lines with `$` are no G-code and are skipped. A probe is assumed to touch at its programmed end.
/// M2 and M30 do not end the outline, as they do not end the lines that a sender sends.
/// @param reader a copy of the controller's own interpreter, with its position, offsets and modes
[[nodiscard]] ProgramOutline program_outline_of(std::string_view program,
                                                cnc::gcode::Interpreter reader,
                                                std::size_t max_points = kMaxOutlinePoints);

}  // namespace sim
