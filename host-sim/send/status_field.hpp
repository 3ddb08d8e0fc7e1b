#pragma once

#include <optional>
#include <string_view>

namespace sim {

/// Returns the content of a field of a status report; nothing if the report has no such field.
/// @param name start of the field, in the form `|NAME:`
[[nodiscard]] inline std::optional<std::string_view> status_field(std::string_view report,
                                                                  std::string_view name) {
  const std::size_t begin = report.find(name);
  if (begin == std::string_view::npos) return std::nullopt;
  const std::string_view rest = report.substr(begin + name.size());
  return rest.substr(0, rest.find_first_of("|>"));
}

}  // namespace sim
