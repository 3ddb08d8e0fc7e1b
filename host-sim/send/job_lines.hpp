#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace sim {

/// A line of a program as it is sent, and its line in the file.
struct JobLine {
  std::string text;        ///< Without comments and blanks, never empty.
  std::size_t number = 0;  ///< In the file, from 1.
  std::uint32_t n = 0;     ///< Sent with it as N; 0 for none.
};

/// The lines of a job. A long one costs its text and eight bytes a line.
class JobLines {
 public:
  /// @param numbered each line is sent with its place among them as N, from 1 on
  explicit JobLines(bool numbered = false) : numbered_{numbered} {}
  explicit JobLines(const std::vector<JobLine>& lines);

  /// Appends a line; @pre `number` rises. Throws std::length_error beyond 4 GiB of text.
  void add(std::string_view text, std::size_t number);

  [[nodiscard]] std::size_t size() const { return ends_.size(); }
  [[nodiscard]] bool empty() const { return ends_.empty(); }
  /// @pre index < size()
  [[nodiscard]] JobLine operator[](std::size_t index) const;
  /// The line's number in the file. @pre index < size()
  [[nodiscard]] std::size_t number_of(std::size_t index) const { return numbers_[index]; }
  /// Characters of the line. @pre index < size()
  [[nodiscard]] std::size_t length_of(std::size_t index) const {
    return ends_[index] - (index == 0 ? 0 : ends_[index - 1]);
  }

 private:
  bool numbered_ = false;
  std::string text_;                    ///< Of all lines, without anything between them.
  std::vector<std::uint32_t> ends_;     ///< Of each line in `text_`.
  std::vector<std::uint32_t> numbers_;  ///< Of each line in the file.
  std::vector<std::uint32_t> given_;    ///< N of each line; empty unless lines came with them.
};

/// A job from one of its lines to its end.
struct JobPart {
  std::shared_ptr<const JobLines> lines;
  std::size_t first = 0;
  std::string motion{};  ///< Words before the first line, see Approach.

  [[nodiscard]] std::size_t size() const { return lines->size() - first; }
  [[nodiscard]] bool empty() const { return size() == 0; }
  /// @pre index < size()
  [[nodiscard]] JobLine operator[](std::size_t index) const;
};

/// The lines of a program that are worth sending: comments, blanks, empty lines and names of
/// programs (`%`, `O1234`, `:1234`) mean nothing to a controller, and cost time or are refused by
/// some. `$` lines stay as they are, and so do their blanks.
/// @param program as prepare_program() leaves it
/// @param numbered each line gets its place among them as number, from 1 on, instead of one that it
/// may have: so a controller can report which one it has come to
[[nodiscard]] JobLines read_job(std::string_view program, bool numbered = false);

/// Characters that a controller takes in a line, comments and blanks apart; and those that a number
/// and a check of the sender's own need of them.
inline constexpr std::size_t kLongestSentLine = 256;
inline constexpr std::size_t kSentNumber = 8;
inline constexpr std::size_t kSentCheck = 9;

/// The first line longer than `most` characters; nothing where there is none.
[[nodiscard]] std::optional<JobLine> line_too_long(const JobLines& job, std::size_t most);

}  // namespace sim
