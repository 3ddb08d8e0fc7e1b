#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace sim::picture {

/// Returns the bytes of a text in base 64. Blanks and line ends within it are skipped. Returns
/// nothing if it contains any other character that is not of base 64.
[[nodiscard]] std::optional<std::string> base64_decoded(std::string_view text);

/// Returns bytes as a text in base 64, padded, on one line.
[[nodiscard]] std::string base64_encoded(std::string_view bytes);

}  // namespace sim::picture
