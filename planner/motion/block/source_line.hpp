#pragma once

#include <cstdint>

namespace cnc::motion {

/// Origin of a motion in the program: the N word of its line, and the number of the motion's part
/// of this line. The part is needed to distinguish the start of a full circle from its end, which
/// is at the same position.
struct SourceLine {
  static constexpr std::uint32_t kMaxParts = 255;

  constexpr SourceLine() = default;
  /// @param line_number N word, at most 9999999 in G-code; 0 for none
  /// @param which index of the part of the line, from 0; from kMaxParts on it is kMaxParts
  // NOLINTNEXTLINE(google-explicit-constructor): a line number stands for the line's first part.
  constexpr SourceLine(std::uint32_t line_number, std::uint32_t which = 0)
      : number{line_number & 0xFF'FFFFU}, part{(which < kMaxParts ? which : kMaxParts) & 0xFFU} {}

  std::uint32_t number : 24 = 0;
  std::uint32_t part : 8 = 0;

  constexpr bool operator==(const SourceLine&) const = default;
};
static_assert(sizeof(SourceLine) == sizeof(std::uint32_t));

}  // namespace cnc::motion
