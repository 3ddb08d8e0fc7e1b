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
  bool is_touch = false;  ///< False if the probe reached the end of its path without a contact.
  std::size_t line = 0;   ///< Line of the log, from 1.
};

/// Answers and work offset of a sender's log.
struct ProbeLog {
  std::vector<ProbeAnswer> answers;
  std::vector<std::size_t> damaged_lines;  ///< Lines with an incomplete `[PRB:` answer.
  /// Zero of the work coordinates in machine coordinates during the answers. Nothing if the log has
  /// neither `WCO:` nor `[G54:…]`.
  std::optional<Eigen::Vector3d> offset;
  std::size_t offset_line = 0;
  /// First line among the answers from which another offset applies; 0 if the offset did not
  /// change.
  std::size_t changed_line = 0;
};

/// Reads a log of Grbl or grblHAL for three to eight axes: its answers, status reports and
/// listings. Other lines are ignored. Lengths are multiplied by `unit_mm`.
///
/// The offset is that of `WCO:` in status reports. Without `WCO:` it is that of the last `[G54:…]`
/// to `[G59:…]` that `[GC:…]` names (`[G54:…]` if there is no `[GC:…]`), together with `[G92:…]`
/// and `[TLO:…]`.
[[nodiscard]] ProbeLog read_probe_log(std::string_view text, double unit_mm = 1.0);

}  // namespace sim::surface
