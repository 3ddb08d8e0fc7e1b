#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "host-sim/import/dxf_group.hpp"
#include "host-sim/import/dxf_tables.hpp"
#include "host-sim/import/letters.hpp"

namespace sim::drawing {

/// Returns whether a type of entity has letters that can be drawn: TEXT, MTEXT, ATTRIB or ATTDEF.
[[nodiscard]] bool is_dxf_text(std::string_view type);

/// The letters of an entity.
struct DxfLetters {
  /// Lines of letters. Here LetterLine::to_mm maps to the axes and units of the drawing, not to mm.
  std::vector<LetterLine> lines{};
  std::string wrong{};  ///< Reason why there are no lines; empty if there are lines.
  /// Texts of notes about properties that are not followed; each text follows the type of the
  /// entity.
  std::vector<std::string> notes{};
};

/// Returns the lines of letters of an entity that has the given style.
/// @param lettering measures lines that are broken at a width, or fitted between two points
/// @pre is_dxf_text(entity.type), no bad_number()
[[nodiscard]] DxfLetters dxf_letters(const DxfEntity& entity,
                                     const DxfStyle& style,
                                     text::Lettering& lettering);

}  // namespace sim::drawing
