#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "host-sim/surface/probe_grid.hpp"

namespace sim::surface {

/// How a program probes a grid: lengths mm, in work coordinates, and feeds mm/min.
struct ProbeProgram {
  ProbeGrid grid;
  double safe_mm = 0.0;     ///< Height of rapids, above everything.
  double depth_mm = 0.0;    ///< A point that is not touched down to here is missed.
  double feed = 0.0;        ///< Of the touch that counts.
  double fast_feed = 0.0;   ///< Of the touch before it; 0: there is none.
  double retract_mm = 1.0;  ///< Between both touches.
  /// Rise above each contact on the way to the next point, under the guard of the probe; 0: rapids
  /// at the safe height.
  double hop_mm = 0.0;
  double travel_feed = 600.0;  ///< Of the guarded ways.
  double tip_mm = 0.0;         ///< Diameter of the tip's ball; told to the reader of the answers.

  /// Returns how many contacts each point has.
  [[nodiscard]] std::size_t touches() const { return fast_feed > 0.0 ? 2 : 1; }
};

/// Throws std::invalid_argument, which names the option, for values that make no program.
void require_probe_program(const ProbeProgram& program);

/// Returns warnings for the operator: of rises that may be shorter than the way on which the tip
/// stops behind a contact, so that the next touch would begin with the probe closed.
[[nodiscard]] std::vector<std::string> warnings_of(const ProbeProgram& program);

/// Returns the G-code: for each point G38.3, so that a point that is missed is reported as
/// `[PRB:x,y,z:0]` and the program goes on. A probe that is closed before a touch ends the program
/// with alarm 4.
///
/// With a hop the way to the next point is G38.3, too: a wall stops the tip. It then rises by
/// another hop and probes there, beside its point, which the reader of the answers names.
/// @pre require_probe_program() does not throw
[[nodiscard]] std::string text_of_probe_program(const ProbeProgram& program);

/// Heading of such a program, by which its answers are read.
struct ProbeHeading {
  ProbeGrid grid;
  double depth_mm = 0.0;
  std::size_t touches = 1;
  double tip_mm = 0.0;
  bool has_guards = false;  ///< Ways are probed, too.
};

[[nodiscard]] ProbeHeading heading_of(const ProbeProgram& program);

/// Reads the heading that text_of_probe_program() wrote. Throws std::invalid_argument where it
/// lacks or is damaged.
[[nodiscard]] ProbeHeading read_probe_heading(std::string_view text, const std::string& name);

}  // namespace sim::surface
