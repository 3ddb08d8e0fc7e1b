#pragma once

#include <cstddef>
#include <optional>
#include <string_view>
#include <vector>

#include "host-sim/machine/program_link.hpp"
#include "host-sim/plot/path.hpp"
#include "planner/gcode/interpreter.hpp"

namespace sim {

/// The path of a program that has not run, seen from above. It is meant only for drawing: it is
/// exact to a few hundredths of a millimetre, and less exact if it is long.
struct ProgramOutline {
  std::vector<PathVertex> vertices;  ///< Points in machine coordinates. Their speeds are not known.
  /// Refused line before which the outline ends, with the reason; empty if the outline is complete.
  std::optional<Refusal> refused;
};

/// Greatest number of points before the path is thinned. Real jobs have fewer points, and this
/// number of points is read within seconds. A line that would exceed the limit is refused.
inline constexpr std::size_t kMaxOutlinePoints = 20'000'000;

/// Returns the path that a program would take if the controller read it now. The path begins at the
/// position of the controller.
///
/// Lines with `$` are no G-code and are skipped. A probe is assumed to touch at its programmed end.
/// M2 and M30 do not end the outline, because a sender also sends the lines after them.
/// @param reader copy of the interpreter of the controller, with its position, offsets and modes
[[nodiscard]] ProgramOutline program_outline_of(std::string_view program,
                                                cnc::gcode::Interpreter reader,
                                                std::size_t max_points = kMaxOutlinePoints);

}  // namespace sim
