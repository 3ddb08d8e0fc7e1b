#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace sim {

/// Returns bytes as text in quotation marks: printable ASCII unchanged, other bytes as `\n`, `\r`,
/// `\t`, `\"`, `\\` or `\xHH`.
[[nodiscard]] std::string escaped(std::string_view bytes);

/// Returns the bytes of a text in the form of escaped(); nothing if the text does not have that
/// form.
[[nodiscard]] std::optional<std::string> unescaped(std::string_view text);

}  // namespace sim
