#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace sim {

/// A line of a program as it is sent, and its line number in the file.
struct JobLine {
  std::string text;        ///< Text without comments and blanks; never empty.
  std::size_t number = 0;  ///< Line number in the file, from 1.
  std::uint32_t n = 0;     ///< Line number N that is sent with the line; 0 for none.
};

/// The lines of a job. They occupy the bytes of their text in memory, plus eight bytes per line.
class JobLines {
 public:
  /// @param numbered whether each line is sent with its position in the job, from 1, as N
  explicit JobLines(bool numbered = false) : numbered_{numbered} {}
  explicit JobLines(const std::vector<JobLine>& lines);

  /// Appends a line. Throws std::length_error if the text would exceed 4 GiB.
  /// @param number line number in the file
  /// @pre `number` is greater than that of the line before
  void add(std::string_view text, std::size_t number);

  [[nodiscard]] std::size_t size() const { return ends_.size(); }
  [[nodiscard]] bool empty() const { return ends_.empty(); }
  /// @pre index < size()
  [[nodiscard]] JobLine operator[](std::size_t index) const;
  /// Returns the line's number in the file. @pre index < size()
  [[nodiscard]] std::size_t number_of(std::size_t index) const { return numbers_[index]; }
  /// Returns the number of characters of the line. @pre index < size()
  [[nodiscard]] std::size_t length_of(std::size_t index) const {
    return ends_[index] - (index == 0 ? 0 : ends_[index - 1]);
  }

 private:
  bool numbered_ = false;
  std::string text_;                    ///< Text of all lines, without separators.
  std::vector<std::uint32_t> ends_;     ///< End of each line in `text_`.
  std::vector<std::uint32_t> numbers_;  ///< Line number in the file, for each line.
  std::vector<std::uint32_t> given_;    ///< N of each line; empty if the lines came without N.
};

/// The part of a job from one of its lines to its end.
struct JobPart {
  std::shared_ptr<const JobLines> lines;
  std::size_t first = 0;
  std::string motion{};  ///< Words to insert at the start of the first line; see Approach.

  [[nodiscard]] std::size_t size() const { return lines->size() - first; }
  [[nodiscard]] bool empty() const { return size() == 0; }
  /// @pre index < size()
  [[nodiscard]] JobLine operator[](std::size_t index) const;
};

/// Returns the lines of a program that have to be sent. Comments, blanks, empty lines and names of
/// programs (`%`, `O1234`, `:1234`) are left out, because they have no effect on a controller, take
/// time, and are refused by some controllers. `$` lines keep their blanks.
/// @param program text that prepare_program() has returned
/// @param numbered whether each line gets its position in the job, from 1, as N in place of its own
///     N, so that a controller can report the line that it has reached
[[nodiscard]] JobLines read_job(std::string_view program, bool numbered = false);

/// kLongestSentLine is the number of characters that a controller accepts in a line, without
/// comments and blanks. Of these, kSentNumber and kSentCheck are the numbers of characters that the
/// number and the check of the sender occupy.
inline constexpr std::size_t kLongestSentLine = 256;
inline constexpr std::size_t kSentNumber = 8;
inline constexpr std::size_t kSentCheck = 9;

/// Returns the first line with more than `most` characters; nothing if no line is too long.
[[nodiscard]] std::optional<JobLine> line_too_long(const JobLines& job, std::size_t most);

}  // namespace sim
