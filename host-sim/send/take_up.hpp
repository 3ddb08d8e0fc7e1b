#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

#include "host-sim/send/job_lines.hpp"

namespace sim {

/// What a controller says of itself before a job begins in its midst.
struct Standing {
  bool laser = false;
  bool in_alarm = false;
  std::uint32_t line = 0;  ///< Of a job, from 1; 0 for none that was interrupted.
  bool known = false;      ///< And its place still holds.

  /// Takes what a line of the controller says about it.
  void read(std::string_view words);
};

/// The lines that ask for it. @param resume the job was interrupted, else it begins anywhere
[[nodiscard]] std::vector<JobLine> standing_questions(bool resume);

/// Where the controller was interrupted: an index of a line. Throws std::invalid_argument where
/// that is of no use.
[[nodiscard]] std::size_t interrupted_at(const std::vector<JobLine>& job, const Standing& standing);

/// The lines that bring the machine to line `index`, with which the job begins; what has to
/// stand before that line is put there. Throws as approach_to().
/// @param resume the path is driven dark up to where the beam went out
[[nodiscard]] std::vector<JobLine> lines_before(std::vector<JobLine>& job,
                                                std::size_t index,
                                                const Standing& standing,
                                                bool resume);

}  // namespace sim
