#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace sim::drawing {

enum class DxfRole : std::uint8_t {
  kLetters,     ///< Letters; left out with a note.
  kAnnotation,  ///< An annotation, or an entity that draws nothing to cut; left out with a note.
  kUnread,      ///< An entity that may be meant to be cut, but is not supported; a fault.
};

/// The role of an entity that is not drawn as lines, with the texts of its message.
struct DxfKind {
  DxfRole role;
  std::string reason{};  ///< Reason in the message; it follows the type of the entity.
  std::string remedy{};
};

/// Returns the kind of an entity by its type. Unknown types are kUnread.
[[nodiscard]] DxfKind dxf_kind(std::string_view type);

}  // namespace sim::drawing
