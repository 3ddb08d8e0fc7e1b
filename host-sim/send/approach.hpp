#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "host-sim/send/job_lines.hpp"

namespace sim {

/// The lines to send before a job that begins at one of its middle lines.
struct Approach {
  std::vector<JobLine> lines;
  std::string motion;  ///< Word in front of the job's first line; may be empty.
};

/// Returns the lines that bring a controller to the state that it would have before line `index` of
/// a job if it had driven all earlier lines. Beam and spindle are off during the approach, except
/// that a mill plunges with its spindle on. If the program moves Z, the approach goes over the
/// highest Z that the program has reached so far.
///
/// Throws std::invalid_argument with the reason if the state cannot be restored. This is so for a
/// position that depends on the start position of the machine, for G92 or G43.4 in use, for a line
/// that continues a spline, and for a line that cannot be read.
/// @param laser whether the tool is a beam, which M3 and G1 turn on ($32)
/// @pre index is one of the job's lines
[[nodiscard]] Approach approach_to(const JobLines& job, std::size_t index, bool laser);

}  // namespace sim
