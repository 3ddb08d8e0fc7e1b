#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "host-sim/import/dxf_group.hpp"
#include "host-sim/import/letters.hpp"

namespace sim::drawing {

/// Stands for a blank at which no line is broken.
inline constexpr char kHeldBlank = '\x01';

/// The words of a TEXT.
struct DxfWords {
  std::string text{};
  bool has_lines = false;    ///< `%%u` or `%%o`: lines under or over letters.
  bool has_unknown = false;  ///< `%%nnn` that is no letter of ASCII: left out.
};

/// Returns words with the characters that `%%c`, `%%d`, `%%p`, `%%%` and `%%nnn` stand for.
[[nodiscard]] DxfWords dxf_words(std::string_view coded);

/// The words of a MTEXT without its codes.
struct MtextWords {
  std::vector<std::string> paragraphs{};
  std::string unfollowed{};  ///< Codes that change how letters look and are left out: `\H \S`.
};

/// Returns the words of a MTEXT, its groups 3 and 1. Font, height, width and slant that are set
/// before the first letter are set in `line`; those behind it are not followed.
[[nodiscard]] MtextWords mtext_words(const DxfEntity& entity, LetterLine& line);

}  // namespace sim::drawing
