#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

#include "host-sim/send/approach.hpp"
#include "host-sim/send/job_lines.hpp"

namespace sim {

/// The state that a controller reports before a job begins at one of its middle lines.
struct Standing {
  bool laser = false;
  bool in_alarm = false;
  std::uint32_t line = 0;  ///< Interrupted line of the job, from 1; 0 for none.
  bool known = false;  ///< Whether the interrupted line and the position of the machine are known.

  /// Reads a line that the controller has sent.
  void read(std::string_view words);
};

/// Returns the lines that request the data of Standing.
/// @param resume whether an interrupted job is resumed; otherwise the job begins at any line
[[nodiscard]] std::vector<JobLine> standing_questions(bool resume);

/// Returns the index of the line at which the controller was interrupted. Throws
/// std::invalid_argument if the job cannot be resumed there.
[[nodiscard]] std::size_t interrupted_at(const JobLines& job, const Standing& standing);

/// Returns the lines that bring the machine to line `index`, at which the job begins, and the word
/// to put in front of that line. Throws as approach_to() does.
/// @param resume whether an interrupted job is resumed; the path up to the point where the beam
/// went off is then driven with the beam off
[[nodiscard]] Approach lines_before(const JobLines& job,
                                    std::size_t index,
                                    const Standing& standing,
                                    bool resume);

}  // namespace sim
