#pragma once

#include <cstdint>

namespace cnc::compensation {

/// Reason why a path cannot be driven at its offset.
enum class Reason : std::uint8_t {
  kEntryTooShort,  ///< The first motion after G41 or G42 is not longer than the offset.
  kExitNotALine,   ///< The first motion after G40 is not a straight line in the plane.
  /// An arc is in another plane, or too many consecutive motions move no axis of the plane.
  kOtherAxis,
  /// The offset path cannot continue after this element, because the path is too narrow.
  kUnreachable,
  kTooNear,     ///< The path next to this element would come too near to another element.
  kWouldSplit,  ///< The path would cross itself and omit a part that could be cut.
};

/// A fault of compensation. Elements are counted from the entry, which is 1; an arc of more than
/// half a turn counts as two. A line number is the N word of the element's line, or 0 if the line
/// has no N word.
struct Fault {
  Reason reason = Reason::kUnreachable;
  std::uint32_t element = 0;
  std::uint32_t line = 0;
  /// For kTooNear and kWouldSplit: number of the element that is in the way.
  std::uint32_t other = 0;
  std::uint32_t other_line = 0;
};

}  // namespace cnc::compensation
