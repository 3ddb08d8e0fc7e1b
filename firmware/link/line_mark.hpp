#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>

#include "planner/base/crc32.hpp"

namespace cnc {

/// What ends a line that carries a check: `*` and its digits, behind them nothing but blanks and
/// comments.
struct LineMark {
  enum class Form : std::uint8_t { kNone, kSum, kCrc };

  std::string_view covered;  ///< All before the `*`.
  std::string_view digits;   ///< One to three decimal ones, or eight hexadecimal ones.

  /// What the check is of the bytes that it covers; kNone where it is wrong.
  [[nodiscard]] Form form() const;
};

/// Finds the check of a line. A `*` within brackets or comments, and one that other digits or
/// anything else follow, is none.
[[nodiscard]] std::optional<LineMark> find_mark(std::string_view line);

/// Finds the eight digits of a CRC that end a line, whatever stands before them.
[[nodiscard]] std::optional<LineMark> mark_at_end(std::string_view line);

/// The CRC-32 of a line as its eight digits, for the other end of the link and for answers.
/// @param digits eight of them
void put_line_crc(std::string_view covered, char* digits);

/// Follows the bytes of a line to the `*` of its check.
class MarkFinder {
 public:
  enum class Part : std::uint8_t { kOther, kStar, kDigit };

  /// Returns whether the byte is the `*`, or one of its digits, as far as is known.
  Part add(char byte);
  [[nodiscard]] bool found() const { return star_ != kNowhere; }
  /// Where the `*` is, and where its digits end. @pre found()
  [[nodiscard]] std::size_t star() const { return star_; }
  [[nodiscard]] std::size_t end() const { return end_; }

 private:
  static constexpr std::size_t kNowhere = ~std::size_t{0};

  std::size_t place_ = 0;
  std::size_t star_ = kNowhere;
  std::size_t end_ = 0;
  char closing_ = ' ';  ///< Of the comment or expression that is open.
};

/// The check of a line that is too long to be kept whole, over all of its bytes.
class LongLineCheck {
 public:
  void add(char byte);
  /// Returns whether there is a check. @param at_end as mark_at_end(), else as find_mark()
  [[nodiscard]] bool found(bool at_end) const;
  /// Returns the form of the check; kNone where it is wrong. @pre found(at_end)
  [[nodiscard]] LineMark::Form form(bool at_end) const;

 private:
  /// The bytes before a `*`, and the digits after it.
  struct Star {
    std::uint32_t crc = 0;
    std::uint8_t sum = 0;
    std::uint8_t count = 0;  ///< Of digits; more than there is space for are none.
    std::array<char, 8> digits{};

    void put(char digit);
    [[nodiscard]] std::string_view text() const;
  };

  MarkFinder finder_{};
  Crc32 crc_{};
  std::uint8_t sum_ = 0;
  Star mark_{};  ///< The one that finder_ knows.
  Star last_{};  ///< The last of all.
};

}  // namespace cnc
