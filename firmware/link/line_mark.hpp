#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>

#include "planner/base/crc32.hpp"

namespace cnc {

/// The check at the end of a line: `*` and its digits, followed only by blanks and comments.
struct LineMark {
  enum class Form : std::uint8_t { kNone, kSum, kCrc };

  std::string_view covered;  ///< Text before the `*`.
  std::string_view digits;   ///< One to three decimal digits, or eight hexadecimal digits.

  /// Returns the form of the check; kNone if the digits are wrong for the covered bytes.
  [[nodiscard]] Form form() const;
};

/// Finds the check of a line. Ignores a `*` within brackets or comments, and a `*` that is followed
/// by more than digits, blanks and comments.
[[nodiscard]] std::optional<LineMark> find_mark(std::string_view line);

/// Finds `*` and eight digits of a CRC at the end of a line, even within a comment.
[[nodiscard]] std::optional<LineMark> mark_at_end(std::string_view line);

/// Writes the CRC-32 of the text of a line as eight digits, for senders and for answers.
/// @param covered text before the `*`
/// @param digits space for eight digits
void put_line_crc(std::string_view covered, char* digits);

/// Reads the bytes of a line one by one to find the `*` of its check.
class MarkFinder {
 public:
  enum class Part : std::uint8_t { kOther, kStar, kDigit };

  /// Processes the next byte. Returns whether, by the bytes so far, the byte is the `*` of the
  /// check or one of its digits.
  Part add(char byte);
  [[nodiscard]] bool found() const { return star_ != kNowhere; }
  /// Return the indices of the `*` and of the first byte after its digits.
  /// @pre found()
  [[nodiscard]] std::size_t star() const { return star_; }
  [[nodiscard]] std::size_t end() const { return end_; }

 private:
  static constexpr std::size_t kNowhere = ~std::size_t{0};

  std::size_t place_ = 0;
  std::size_t star_ = kNowhere;
  std::size_t end_ = 0;
  char closing_ = ' ';  ///< Byte that ends the open comment or expression; a blank if none is open.
};

/// The check of a line that is too long to be stored completely, computed over all of its bytes.
class LongLineCheck {
 public:
  void add(char byte);
  /// Returns whether the line has a check.
  /// @param at_end searches like mark_at_end(); otherwise searches like find_mark()
  [[nodiscard]] bool found(bool at_end) const;
  /// Returns the form of the check; kNone if it is wrong.
  /// @pre found(at_end)
  [[nodiscard]] LineMark::Form form(bool at_end) const;

 private:
  /// Sum and CRC of the bytes before a `*`, and the digits after it.
  struct Star {
    std::uint32_t crc = 0;
    std::uint8_t sum = 0;
    /// Number of digits; the count stops at the first digit that does not fit.
    std::uint8_t count = 0;
    std::array<char, 8> digits{};

    void put(char digit);
    [[nodiscard]] std::string_view text() const;
  };

  MarkFinder finder_{};
  Crc32 crc_{};
  std::uint8_t sum_ = 0;
  Star mark_{};  ///< Content before and after the `*` that `finder_` found.
  Star last_{};  ///< Content before and after the last `*` of the line.
};

}  // namespace cnc
