#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace sim {

/// A line of a program as it is sent, and where it stands.
struct JobLine {
  std::string text;        ///< Without comments and blanks, never empty.
  std::size_t number = 0;  ///< In the file, from 1.
  std::uint32_t n = 0;     ///< Sent with it as N; 0 for none.
};

/// What of a program is worth its way over a link: comments, blanks, empty lines and names of
/// programs (`%`, `O1234`, `:1234`) mean nothing to a controller, and cost time or are refused by
/// some. `$` lines stay as they are, and so do their blanks.
/// @param program as prepare_program() leaves it
[[nodiscard]] std::vector<JobLine> read_job(std::string_view program);

/// Gives each line its place among them as number, from 1 on, instead of one that it may have: so
/// a controller can tell which one it has come to.
void number_lines(std::vector<JobLine>& job);

}  // namespace sim
