#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace sim {

/// Bytes as text in quotation marks: printable ASCII as it is, the others as
/// `\n`, `\r`, `\t`, `\"`, `\\` or `\xHH`.
[[nodiscard]] std::string escaped(std::string_view bytes);

/// The bytes back; nothing when the text is not of that form.
[[nodiscard]] std::optional<std::string> unescaped(std::string_view text);

}  // namespace sim
