#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string_view>

namespace sim::surface {

/// Fields of a line, without blanks and quotation marks around them.
struct XyzFields {
  static constexpr std::size_t kMost = 16;

  std::array<std::string_view, kMost> fields{};
  std::size_t count = 0;  ///< All of the line; those beyond kMost are not listed.

  [[nodiscard]] std::size_t listed() const { return count < kMost ? count : kMost; }
};

/// How a text of points separates its numbers.
struct XyzDialect {
  char separator = ' ';  ///< `;` or `,`; a blank stands for blanks and tabs.
  bool decimal_comma = false;

  /// Returns the fields of a line. Empty fields at its end are left out: spreadsheets write them.
  [[nodiscard]] XyzFields split(std::string_view line) const;
  /// Returns the number of a field; nothing where it is none, NaN for an empty field.
  [[nodiscard]] std::optional<double> number(std::string_view field) const;
};

/// Returns the dialect of the first line that shows one. Semicolons separate wherever they are,
/// and commas are decimal marks then; so they are where blanks alone separate numbers.
[[nodiscard]] XyzDialect dialect_of(std::string_view text);

/// Returns `line` without a comment, which # or // begins, and without blanks around it.
[[nodiscard]] std::string_view without_comment(std::string_view line);

}  // namespace sim::surface
