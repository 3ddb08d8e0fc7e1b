#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace sim::drawing {

enum class DxfRole : std::uint8_t {
  kLetters,     ///< Left out with a note.
  kAnnotation,  ///< Annotates the drawing, or draws nothing to cut; left out with a note.
  kUnread,      ///< May be meant to be cut, but is not read: a fault.
};

/// The role of an entity whose lines are not read, with the text of its message.
struct DxfKind {
  DxfRole role;
  std::string reason{};  ///< Reason in a message, after the entity's type.
  std::string remedy{};
};

/// Returns the kind of an entity by its type. Unknown types are kUnread.
[[nodiscard]] DxfKind dxf_kind(std::string_view type);

}  // namespace sim::drawing
