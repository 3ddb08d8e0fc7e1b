#pragma once

#include <array>
#include <cstdint>
#include <span>

namespace machine {

/// Cycles that a Cortex-M4 with its floating-point unit needs for an instruction from memory
/// without wait states (Cortex-M4 Technical Reference Manual r0p1, tables 3-1 and 7-1), and what
/// its neighbours must know of it. A division of integers has its worst, 12, for 2 to 12. A branch
/// has the 1 of one that is not taken: the manual's 1 to 3 to refill the pipeline come on top.
struct InstructionCost {
  static constexpr std::uint8_t kNone = 0xFF;  ///< No register.

  std::uint32_t address = 0;
  std::uint8_t size = 2;  ///< Bytes.
  std::uint8_t cycles = 1;
  /// A load or store of one register: a load behind one takes a cycle less, as they overlap.
  bool moves_one = false;
  bool loads = false;
  bool divides = false;  ///< Integers or single-precision numbers, or a square root.
  // Single-precision registers: a result that the next instruction reads is a cycle late.
  std::uint8_t result = kNone;
  std::array<std::uint8_t, 3> operands{kNone, kNone, kNone};

  [[nodiscard]] std::uint32_t end() const { return address + size; }
};

/// @param code the two or four bytes at `address`
[[nodiscard]] InstructionCost cost_of(std::uint32_t address, std::span<const std::uint8_t> code);

}  // namespace machine
