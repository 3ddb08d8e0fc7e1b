#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace sim::surface {

/// One `[PRB:x,y,z:1]` of a controller, in machine coordinates.
struct ProbeAnswer {
  Eigen::Vector3d place = Eigen::Vector3d::Zero();
  bool is_touch = false;  ///< False where the probe came to its end without a contact.
  std::size_t line = 0;   ///< Of the log, from 1.
};

/// Answers and work offset of a sender's log.
struct ProbeLog {
  std::vector<ProbeAnswer> answers;
  std::vector<std::size_t> damaged_lines;  ///< Lines whose `[PRB:` is not whole.
  /// Zero of the work coordinates in the machine's, while the answers came; nothing if the log has
  /// neither `WCO:` nor `[G54:…]`.
  std::optional<Eigen::Vector3d> offset;
  std::size_t offset_line = 0;
  /// A line among the answers from which another offset holds; 0 for none.
  std::size_t changed_line = 0;
};

/// Reads a log: answers, status reports and listings of Grbl and grblHAL with three to eight axes,
/// among anything else. Lengths are multiplied by `unit_mm`.
///
/// The offset is that of `WCO:` in status reports; without one, of the last `[G54:…]` to `[G59:…]`
/// that `[GC:…]` names (`[G54:…]` without it), with `[G92:…]` and `[TLO:…]`.
[[nodiscard]] ProbeLog read_probe_log(std::string_view text, double unit_mm = 1.0);

}  // namespace sim::surface
