#pragma once

#include <array>
#include <cstdint>
#include <span>

namespace machine {

/// Cycles of a Cortex-M4 with its floating-point unit for an instruction from memory without wait
/// states (Cortex-M4 Technical Reference Manual r0p1, tables 3-1 and 7-1), and the properties that
/// affect neighbouring instructions. An integer division counts with its worst case, 12, instead of
/// 2 to 12. A branch counts 1, as if it is not taken: the manual's 1 to 3 cycles to refill the
/// pipeline are added later.
struct InstructionCost {
  static constexpr std::uint8_t kNone = 0xFF;  ///< No register.

  std::uint32_t address = 0;
  std::uint8_t size = 2;  ///< Size, bytes.
  std::uint8_t cycles = 1;
  /// A load or store of one register: after another load it takes a cycle less, because both
  /// overlap.
  bool moves_one = false;
  bool loads = false;
  bool divides = false;  ///< A division of integers or single-precision numbers, or a square root.
  // Single-precision registers: a result that the next instruction reads costs one more cycle.
  std::uint8_t result = kNone;
  std::array<std::uint8_t, 3> operands{kNone, kNone, kNone};

  [[nodiscard]] std::uint32_t end() const { return address + size; }
};

/// Returns the cost of an instruction. @param code the two or four bytes at `address`
[[nodiscard]] InstructionCost cost_of(std::uint32_t address, std::span<const std::uint8_t> code);

}  // namespace machine
