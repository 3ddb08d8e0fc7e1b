#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace sim::drawing {

enum class DxfRole : std::uint8_t {
  kLetters,     ///< Left out with a note.
  kAnnotation,  ///< Says something of the drawing, or draws nothing to cut; left out with a note.
  kUnread,      ///< Draws what may be meant to be cut, and is not read: a fault.
};

/// What becomes of an entity that draws no lines that are read.
struct DxfKind {
  DxfRole role;
  std::string reason{};  ///< To follow the entity's type.
  std::string remedy{};
};

/// Returns the kind of an entity by its type. Unknown ones are kUnread.
[[nodiscard]] DxfKind dxf_kind(std::string_view type);

}  // namespace sim::drawing
