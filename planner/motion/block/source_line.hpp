#pragma once

#include <cstdint>

namespace cnc::motion {

/// Where in the program a motion comes from: the N word of its line, and the part of the line. The
/// part is needed because a circle passes its start twice.
struct SourceLine {
  static constexpr std::uint32_t kMaxParts = 255;

  constexpr SourceLine() = default;
  /// @param line_number 0 for none; G-code has 9999999 at most
  /// @param which number of the part, from 0; all parts from kMaxParts on count as one
  // NOLINTNEXTLINE(google-explicit-constructor): a number is a line's first part.
  constexpr SourceLine(std::uint32_t line_number, std::uint32_t which = 0)
      : number{line_number & 0xFF'FFFFU}, part{(which < kMaxParts ? which : kMaxParts) & 0xFFU} {}

  std::uint32_t number : 24 = 0;
  std::uint32_t part : 8 = 0;

  constexpr bool operator==(const SourceLine&) const = default;
};
static_assert(sizeof(SourceLine) == sizeof(std::uint32_t));

}  // namespace cnc::motion
