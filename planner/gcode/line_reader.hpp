#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>

#include "planner/gcode/decimal.hpp"
#include "planner/gcode/fault.hpp"

namespace cnc::gcode {

/// Greatest length of a line without its CR and LF and without comments.
inline constexpr std::size_t kLongestLine = 256;
/// Greatest length of a line with comments. It follows from the 16 bits of a column.
inline constexpr std::size_t kLongestLineWithComments = 65'534;

/// Returns the line without the byte order mark, which some editors put at the start of a file.
[[nodiscard]] std::string_view without_mark(std::string_view line);

/// A letter, its number, and the column of the word.
struct Word {
  char letter = ' ';         ///< 'A'…'Z'.
  std::uint16_t column = 0;  ///< Column of the letter in the line, 1-based.
  Decimal value{};
};

/// Splits a line into words.
///
/// The reader ignores everything that RS274/NGC permits to ignore: blanks, comments in ( ) and
/// after ; with any bytes, CR and LF at the end, and lower case. It also ignores control bytes, a
/// byte order mark, and a line that begins with %, which names a program. A : at the start of a
/// line counts as an O. Everything else outside a word is refused.
///
/// After each call that has returned no fault, the reader is at a word or at the end of the line.
class LineReader {
 public:
  /// @param line must outlive the reader
  explicit LineReader(std::string_view line) : line_{line} {}

  /// Advances to the first word. Must be called once, before all other functions.
  /// @param block_delete If true, the text after a / at the start of the line or after N is ignored
  /// like a comment. If false, only the / is ignored. A digit directly after the / (switches 1 to
  /// 9) is part of the /.
  [[nodiscard]] Refusal begin(bool block_delete);

  [[nodiscard]] bool at_end() const { return at_ == line_.size(); }

  /// Reads the word at the present index and advances to the next word.
  [[nodiscard]] Refusal read(Word& word);
  /// Skips a / after the N word that was read last. The effect is the same as in begin().
  [[nodiscard]] Refusal pass_slash_after_number(bool block_delete) {
    return at('/') ? pass_slash(block_delete) : std::nullopt;
  }

  /// Returns whether a colon and another value of the last word follow.
  [[nodiscard]] bool at_more_values() const { return at(':'); }
  /// Reads the value after the colon into `word`, which keeps its letter, and advances. @pre
  /// at_more_values()
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
  std::size_t first_ = 0;  ///< Index at which the first word begins.
};

}  // namespace cnc::gcode
