#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "host-sim/send/job_lines.hpp"

namespace sim {

/// The lines that are sent before a line of a job that begins there.
struct Approach {
  std::vector<JobLine> lines;
  std::string motion;  ///< The word that has to stand before the line; empty for none.
};

/// Brings a controller to where it would be before line `index` of a job, had it driven all lines
/// before: beam and spindle off up to that point, and then with the modes that hold there.
/// Where the program moves Z, over the highest place that it has come to.
///
/// Throws std::invalid_argument with the reason where the lines before leave it open: a position
/// that depends on where the machine stood, an offset of G92, a line that cannot be read.
/// @param laser a beam, which is lit by M3 and G1 ($32)
/// @pre index is one of the job's lines
[[nodiscard]] Approach approach_to(const JobLines& job, std::size_t index, bool laser);

}  // namespace sim
