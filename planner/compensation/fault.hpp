#pragma once

#include <cstdint>

namespace cnc::compensation {

/// Why a path cannot be driven beside what is programmed.
enum class Reason : std::uint8_t {
  kEntryTooShort,  ///< The first motion after G41.1 or G42.1 is no longer than the offset.
  kExitNotALine,   ///< The first motion after G40 is no straight line in the plane.
  kOtherAxis,      ///< An arc in another plane, or too many motions that stand in the plane.
  kUnreachable,    ///< Nothing at the offset leads on from this element: it is narrower than that.
  kTooNear,        ///< Beside this element the path would come too near to another one.
  kWouldSplit,     ///< The path would cross itself, and leave out what could be cut.
};

/// Elements are counted from the entry, which is 1; arcs of more than half a turn are two. A
/// line number is N of the element's line, 0 for none.
struct Fault {
  Reason reason = Reason::kUnreachable;
  std::uint32_t element = 0;
  std::uint32_t line = 0;
  std::uint32_t other = 0;  ///< Of kTooNear and kWouldSplit: the one that is in the way.
  std::uint32_t other_line = 0;
};

}  // namespace cnc::compensation
