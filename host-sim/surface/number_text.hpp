#pragma once

#include <array>
#include <charconv>
#include <cstdint>
#include <optional>
#include <string_view>
#include <system_error>

namespace sim::surface {

/// Converts the complete `word` to a number, for example `-1`, `+.5`, `1e-3`, `nan` or `inf`.
/// Returns nothing for other words and for numbers outside the range of a double.
[[nodiscard]] inline std::optional<double> parsed_number(std::string_view word) {
  if (word.size() > 1 && word.front() == '+' && word[1] != '-') word.remove_prefix(1);
  double value = 0.0;
  const auto [stop, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (error != std::errc{} || stop != word.data() + word.size()) return {};
  return value;
}

/// Converts the complete `word` to a number. The decimal mark may be a comma or a point.
[[nodiscard]] inline std::optional<double> parsed_comma_number(std::string_view word) {
  std::array<char, 64> buffer{};
  const std::size_t comma = word.find(',');
  if (comma == std::string_view::npos) return parsed_number(word);
  if (word.size() > buffer.size() || word.find('.') != std::string_view::npos) return {};
  word.copy(buffer.data(), word.size());
  buffer[comma] = '.';
  return parsed_number({buffer.data(), word.size()});
}

/// Converts the complete `word` to a whole number. Returns nothing for a sign, a fraction or a
/// number of more than 64 bits.
[[nodiscard]] inline std::optional<std::uint64_t> parsed_count(std::string_view word) {
  std::uint64_t value = 0;
  const auto [stop, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (error != std::errc{} || stop != word.data() + word.size()) return {};
  return value;
}

}  // namespace sim::surface
