#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string_view>

namespace sim::surface {

/// Fields of a line, without blanks and quotation marks around them.
struct XyzFields {
  static constexpr std::size_t kMax = 16;

  std::array<std::string_view, kMax> fields{};
  std::size_t count = 0;  ///< Number of all fields of the line; only the first kMax are stored.

  [[nodiscard]] std::size_t listed() const { return count < kMax ? count : kMax; }
};

/// How a text of points separates its numbers.
struct XyzDialect {
  char separator = ' ';  ///< `;` or `,`, or a blank that stands for blanks and tabs.
  bool decimal_comma = false;

  /// Returns the fields of a line. Empty fields at its end are left out, because spreadsheets write
  /// them.
  [[nodiscard]] XyzFields split(std::string_view line) const;
  /// Returns the number in a field; nothing if it is not a number, NaN for an empty field.
  [[nodiscard]] std::optional<double> number(std::string_view field) const;
};

/// Returns the dialect of the first line that shows one. Semicolons always separate, and commas are
/// then decimal marks. Commas are decimal marks, too, if blanks alone separate the numbers.
[[nodiscard]] XyzDialect dialect_of(std::string_view text);

/// Returns `line` without its comment, which begins with # or //, and without blanks at its ends.
[[nodiscard]] std::string_view without_comment(std::string_view line);

}  // namespace sim::surface
