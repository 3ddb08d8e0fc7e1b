#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "host-sim/import/dxf_group.hpp"
#include "host-sim/import/letters.hpp"

namespace sim::drawing {

/// Character that represents a no-break blank, at which no line is broken.
inline constexpr char kHeldBlank = '\x01';

/// The words of a TEXT.
struct DxfWords {
  std::string text{};
  bool has_lines = false;    ///< The text has `%%u` or `%%o`: lines under or over letters.
  bool has_unknown = false;  ///< The text has a `%%nnn` that is no letter of ASCII; it is left out.
};

/// Returns the words after `%%c`, `%%d`, `%%p`, `%%%` and `%%nnn` are replaced by their characters.
[[nodiscard]] DxfWords dxf_words(std::string_view coded);

/// The words of a MTEXT without its codes.
struct MtextWords {
  std::vector<std::string> paragraphs{};
  /// Codes that change the look of letters and are not followed: `\H \S`.
  std::string unfollowed{};
};

/// Returns the words of a MTEXT, from its groups 3 and 1. Font, height, width and slant that are
/// set before the first letter are set in `line`. Those that are set after it are not followed.
[[nodiscard]] MtextWords mtext_words(const DxfEntity& entity, LetterLine& line);

}  // namespace sim::drawing
