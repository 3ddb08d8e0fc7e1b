#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace sim {

/// A line of a program as it is sent, and where it stands.
struct JobLine {
  std::string text;        ///< Without comments and blanks, never empty.
  std::size_t number = 0;  ///< In the file, from 1.
};

/// What of a program is worth its way over a link: comments, blanks, empty lines and `%` mean
/// nothing to any controller, and cost time. `$` lines stay as they are, and so do their blanks.
[[nodiscard]] std::vector<JobLine> read_job(std::string_view program);

}  // namespace sim
