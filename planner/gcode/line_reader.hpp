#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>

#include "planner/gcode/decimal.hpp"
#include "planner/gcode/fault.hpp"

namespace cnc::gcode {

/// The longest line that is read, its CR and LF and its comments not counted.
inline constexpr std::size_t kLongestLine = 256;
/// The same with its comments: columns are 16 bits wide.
inline constexpr std::size_t kLongestLineWithComments = 65'534;

/// The line without the byte order mark that some editors put before the first one.
[[nodiscard]] std::string_view without_mark(std::string_view line);

/// A letter and its number, and where it stands.
struct Word {
  char letter = ' ';         ///< 'A'…'Z'.
  std::uint16_t column = 0;  ///< 1-based.
  Decimal value{};
};

/// Splits one line into words.
///
/// What RS274/NGC lets pass is passed over: blanks anywhere, comments in ( )
/// and after ; with any bytes in them, CR and LF at the end, lower case. So are control bytes, a
/// byte order mark, and a line that begins with %, which names a program. A : at the front is an O.
/// Everything else outside a word is refused.
///
/// Stands at a word or at the end whenever a call has returned no fault.
class LineReader {
 public:
  /// @param line must outlive the reader.
  explicit LineReader(std::string_view line) : line_{line} {}

  /// Goes to the first word. Call once, before anything else.
  /// @param block_delete true: what follows a / at the front or after N is as good as a comment;
  ///   false: the / means nothing. A digit after it, as of switches 1 to 9, belongs to it.
  [[nodiscard]] Refusal begin(bool block_delete);

  [[nodiscard]] bool at_end() const { return at_ == line_.size(); }

  /// Reads the word here and goes to the next one.
  /// @pre !at_end()
  [[nodiscard]] Refusal read(Word& word);
  /// Goes behind a / that follows the N read last, as begin() does.
  [[nodiscard]] Refusal pass_slash_after_number(bool block_delete) {
    return at('/') ? pass_slash(block_delete) : std::nullopt;
  }

  /// Another value of the word read last stands here, after a colon.
  [[nodiscard]] bool at_more_values() const { return at(':'); }
  /// Reads it and goes on; `word` keeps its letter. @pre at_more_values()
  [[nodiscard]] Refusal read_more(Word& word) { return read_value(word.letter, word); }

 private:
  void drop_line_end();
  [[nodiscard]] bool too_long() const;
  [[nodiscard]] Refusal read_value(char letter, Word& word);
  [[nodiscard]] Refusal skip_to_word();
  [[nodiscard]] Refusal skip_comment();
  [[nodiscard]] Refusal pass_percent();
  [[nodiscard]] Refusal pass_slash(bool block_delete);
  [[nodiscard]] bool at(char wanted) const { return !at_end() && line_[at_] == wanted; }
  [[nodiscard]] Fault fault_here(FaultDetail detail) const;
  [[nodiscard]] Fault not_a_letter() const;
  [[nodiscard]] Fault no_number(char letter, DecimalError error) const;

  std::string_view line_;
  std::size_t at_ = 0;
  std::size_t first_ = 0;  ///< Where the first word begins.
};

}  // namespace cnc::gcode
