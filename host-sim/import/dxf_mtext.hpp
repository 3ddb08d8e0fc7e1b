#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "host-sim/import/dxf_group.hpp"
#include "host-sim/import/letters.hpp"

namespace sim::drawing {

/// Character that represents a no-break space. Lines are not broken at this character.
inline constexpr char kHeldBlank = '\x01';

/// The words of a TEXT.
struct DxfWords {
  std::string text{};
  /// True if the text has `%%u` or `%%o`, which draw lines under or over letters.
  bool has_lines = false;
  /// True if the text has a `%%nnn` that is no ASCII character. Such codes are left out.
  bool has_unknown = false;
};

/// Returns the words of a TEXT, with `%%c`, `%%d`, `%%p`, `%%%` and `%%nnn` replaced by the
/// characters that they stand for.
[[nodiscard]] DxfWords dxf_words(std::string_view coded);

/// The words of a MTEXT without its codes.
struct MtextWords {
  std::vector<std::string> paragraphs{};
  /// Codes that change the appearance of letters and were not applied, such as `\H \S`.
  std::string unfollowed{};
};

/// Returns the words of a MTEXT, from its groups 3 and 1. Stores the font, height, width and slant
/// that codes set before the first letter in `line`. Later changes of these properties are not
/// followed.
[[nodiscard]] MtextWords mtext_words(const DxfEntity& entity, LetterLine& line);

}  // namespace sim::drawing
