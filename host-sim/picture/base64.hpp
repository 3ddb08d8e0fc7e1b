#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace sim::picture {

/// Returns the bytes that a text in base 64 encodes. Blanks and line ends in the text are skipped.
/// Returns nothing if the text contains any other character that is not part of base 64.
[[nodiscard]] std::optional<std::string> base64_decoded(std::string_view text);

/// Returns bytes encoded as a padded text in base 64, on one line.
[[nodiscard]] std::string base64_encoded(std::string_view bytes);

}  // namespace sim::picture
