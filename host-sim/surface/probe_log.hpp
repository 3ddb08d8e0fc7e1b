#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace sim::surface {

/// One answer `[PRB:x,y,z:1]` of a controller, in machine coordinates.
struct ProbeAnswer {
  Eigen::Vector3d place = Eigen::Vector3d::Zero();
  /// Whether the probe had a contact; false if it reached the end of its path without one.
  bool is_touch = false;
  std::size_t line = 0;  ///< Line of the log, from 1.
};

/// Probing answers and work offset from the log of a sender program.
struct ProbeLog {
  std::vector<ProbeAnswer> answers;
  std::vector<std::size_t> damaged_lines;  ///< Lines with an incomplete `[PRB:` answer.
  /// Origin of the work coordinates, in machine coordinates, at the first answer. Empty if the log
  /// has neither `WCO:` nor `[G54:…]`.
  std::optional<Eigen::Vector3d> offset;
  std::size_t offset_line = 0;
  /// First line between the first and the last answer at which the offset changes; 0 if there is
  /// none.
  std::size_t changed_line = 0;
};

/// Reads a log of Grbl or grblHAL for three to eight axes. Evaluates probing answers, status
/// reports and listings, and ignores other lines. Lengths are multiplied by `unit_mm`.
///
/// The offset is the value of `WCO:` in status reports. Without `WCO:`, the offset is the sum of
/// the active coordinate system's offset, `[G92:…]` and `[TLO:…]`. `[GC:…]` names the active
/// system, one of G54 to G59. Without `[GC:…]`, G54 is active.
[[nodiscard]] ProbeLog read_probe_log(std::string_view text, double unit_mm = 1.0);

}  // namespace sim::surface
