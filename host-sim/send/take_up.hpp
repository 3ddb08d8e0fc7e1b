#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

#include "host-sim/send/approach.hpp"
#include "host-sim/send/job_lines.hpp"

namespace sim {

/// The state that a controller reports before a job begins in its midst.
struct Standing {
  bool laser = false;
  bool in_alarm = false;
  std::uint32_t line = 0;  ///< Of a job, from 1; 0 for none that was interrupted.
  bool known = false;      ///< And the machine's position is known.

  /// Reads a line of the controller.
  void read(std::string_view words);
};

/// The lines that ask for it. @param resume the job was interrupted, else it begins anywhere
[[nodiscard]] std::vector<JobLine> standing_questions(bool resume);

/// Where the controller was interrupted: an index of a line. Throws std::invalid_argument where
/// that is of no use.
[[nodiscard]] std::size_t interrupted_at(const JobLines& job, const Standing& standing);

/// The lines that bring the machine to line `index`, with which the job begins, and the word that
/// has to stand before that line. Throws as approach_to().
/// @param resume the path is driven, beam off, up to where the beam went out
[[nodiscard]] Approach lines_before(const JobLines& job,
                                    std::size_t index,
                                    const Standing& standing,
                                    bool resume);

}  // namespace sim
