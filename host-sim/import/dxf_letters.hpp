#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "host-sim/import/dxf_group.hpp"
#include "host-sim/import/dxf_tables.hpp"
#include "host-sim/import/letters.hpp"

namespace sim::drawing {

/// Returns whether an entity is letters that can be drawn: TEXT, MTEXT, ATTRIB, ATTDEF.
[[nodiscard]] bool is_dxf_text(std::string_view type);

/// What an entity writes.
struct DxfLetters {
  std::vector<LetterLine> lines{};   ///< To the axes and units of the drawing, not to mm.
  std::string wrong{};               ///< Empty, or why there are none.
  std::vector<std::string> notes{};  ///< What is not followed, behind the entity's type.
};

/// Returns the lines of an entity in its style.
/// @param lettering measures lines that are wrapped or fitted between two places
/// @pre is_dxf_text(entity.type), no bad_number()
[[nodiscard]] DxfLetters dxf_letters(const DxfEntity& entity,
                                     const DxfStyle& style,
                                     text::Lettering& lettering);

}  // namespace sim::drawing
