#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "host-sim/surface/probe_grid.hpp"

namespace sim::surface {

/// Parameters of a program that probes a grid. Lengths are mm in work coordinates, feeds are
/// mm/min.
struct ProbeProgram {
  ProbeGrid grid;
  double safe_mm = 0.0;  ///< Z of rapids, above all obstacles.
  /// Z at which a probing motion ends. A point without a contact down to this Z is missed.
  double depth_mm = 0.0;
  double feed = 0.0;  ///< Feed of the measured touch.
  /// Feed of a faster touch before the measured touch; 0: no faster touch.
  double fast_feed = 0.0;
  double retract_mm = 1.0;  ///< Rise between the faster touch and the measured touch.
  /// Rise above each contact before the motion to the next point, which is a guarded probing
  /// motion. 0: rapids at the safe height instead.
  double hop_mm = 0.0;
  double travel_feed = 600.0;  ///< Feed of the guarded motions.
  /// Diameter of the tip's ball. The program's heading passes it to the reader of the answers.
  double tip_mm = 0.0;

  /// Returns the number of contacts at each point.
  [[nodiscard]] std::size_t touches() const { return fast_feed > 0.0 ? 2 : 1; }
};

/// Throws std::invalid_argument, with the option's name, for values that do not give a usable
/// program.
void require_probe_program(const ProbeProgram& program);

/// Returns warnings for the operator about rises that may be too short. If a rise is shorter than
/// the stopping distance of the tip after a contact, the next touch begins with the probe closed.
[[nodiscard]] std::vector<std::string> warnings_of(const ProbeProgram& program);

/// Returns the G-code of a probing program. Each point is probed with G38.3, so that a missed point
/// is reported as `[PRB:x,y,z:0]` and the program continues. If the probe is closed before a touch,
/// the program ends with alarm 4.
///
/// With a hop, the motion to the next point is a G38.3, too, so that a wall stops the tip. The tip
/// then rises by another hop and probes at this position, which differs from the grid point. The
/// reader of the answers reports such points.
/// @pre require_probe_program() does not throw
[[nodiscard]] std::string text_of_probe_program(const ProbeProgram& program);

/// Heading of a probing program. It contains the parameters that the reader of the answers needs.
struct ProbeHeading {
  ProbeGrid grid;
  double depth_mm = 0.0;
  std::size_t touches = 1;
  double tip_mm = 0.0;
  bool has_guards = false;  ///< Whether the motions between points are probing motions, too.
};

[[nodiscard]] ProbeHeading heading_of(const ProbeProgram& program);

/// Reads the heading that text_of_probe_program() wrote. Throws std::invalid_argument if the
/// heading is missing or damaged.
[[nodiscard]] ProbeHeading read_probe_heading(std::string_view text, const std::string& name);

}  // namespace sim::surface
