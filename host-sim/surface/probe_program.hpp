#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "host-sim/surface/probe_grid.hpp"

namespace sim::surface {

/// How a program probes a grid. Lengths are mm in work coordinates, feeds mm/min.
struct ProbeProgram {
  ProbeGrid grid;
  double safe_mm = 0.0;  ///< Height of rapids, above all obstacles.
  /// Height at which a touch ends. A point without a contact down to here is missed.
  double depth_mm = 0.0;
  double feed = 0.0;        ///< Feed of the touch that is measured.
  double fast_feed = 0.0;   ///< Feed of the touch before the measured one; 0: no such touch.
  double retract_mm = 1.0;  ///< Rise between both touches.
  /// Rise above each contact before the path to the next point. The path is driven as a guarded
  /// probing motion. 0: rapids at the safe height instead.
  double hop_mm = 0.0;
  double travel_feed = 600.0;  ///< Feed of the guarded paths.
  /// Diameter of the tip's ball, reported to the reader of the answers.
  double tip_mm = 0.0;

  /// Returns the number of contacts at each point.
  [[nodiscard]] std::size_t touches() const { return fast_feed > 0.0 ? 2 : 1; }
};

/// Throws std::invalid_argument, which names the option, for values that do not give a usable
/// program.
void require_probe_program(const ProbeProgram& program);

/// Returns warnings for the operator. They concern rises that may be shorter than the distance in
/// which the tip stops after a contact, so that the next touch would begin with the probe closed.
[[nodiscard]] std::vector<std::string> warnings_of(const ProbeProgram& program);

/// Returns the G-code. Each point is probed with G38.3, so that a missed point is reported as
/// `[PRB:x,y,z:0]` and the program continues. If the probe is closed before a touch, the program
/// ends with alarm 4.
///
/// With a hop the path to the next point is a G38.3, too, so that a wall stops the tip. The tip
/// then rises by another hop and probes there, offset from its point. The reader of the answers
/// reports such points.
/// @pre require_probe_program() does not throw
[[nodiscard]] std::string text_of_probe_program(const ProbeProgram& program);

/// Heading of a probing program. The answers are read with its help.
struct ProbeHeading {
  ProbeGrid grid;
  double depth_mm = 0.0;
  std::size_t touches = 1;
  double tip_mm = 0.0;
  bool has_guards = false;  ///< Whether the paths between points are probed, too.
};

[[nodiscard]] ProbeHeading heading_of(const ProbeProgram& program);

/// Reads the heading that text_of_probe_program() wrote. Throws std::invalid_argument if the
/// heading is missing or damaged.
[[nodiscard]] ProbeHeading read_probe_heading(std::string_view text, const std::string& name);

}  // namespace sim::surface
