#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string_view>

namespace sim::surface {

/// Fields of a line, without the blanks and quotation marks around each field.
struct XyzFields {
  static constexpr std::size_t kMax = 16;

  std::array<std::string_view, kMax> fields{};
  std::size_t count = 0;  ///< Number of fields in the line; only the first kMax fields are stored.

  [[nodiscard]] std::size_t listed() const { return count < kMax ? count : kMax; }
};

/// Separator and decimal mark of the numbers in a text of points.
struct XyzDialect {
  char separator = ' ';  ///< Separator: `;` or `,`, or a blank, which represents blanks and tabs.
  bool decimal_comma = false;

  /// Returns the fields of a line. Empty fields at the end of the line are left out, because
  /// spreadsheets write them.
  [[nodiscard]] XyzFields split(std::string_view line) const;
  /// Returns the number in a field: NaN if the field is empty, nothing if it is not a number.
  [[nodiscard]] std::optional<double> number(std::string_view field) const;
};

/// Returns the dialect of a text, derived from the first line that allows it. If a line has
/// semicolons, the semicolons separate the fields, and commas are decimal marks. Commas are decimal
/// marks, too, if blanks alone separate the numbers.
[[nodiscard]] XyzDialect dialect_of(std::string_view text);

/// Returns `line` without its comment, which begins with # or //, and without blanks at its ends.
[[nodiscard]] std::string_view without_comment(std::string_view line);

}  // namespace sim::surface
