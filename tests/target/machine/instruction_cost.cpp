#include "tests/target/machine/instruction_cost.hpp"

#include <bit>

namespace machine {
namespace {

// Encodings: ARMv7-M Architecture Reference Manual, A5.2 (16 bits), A5.3 (32 bits), A6.4 to A6.7
// (floating point).

constexpr unsigned kDivision = 12, kFloatDivision = 14, kFloatMultiplyAdd = 3;

unsigned ones(unsigned bits) { return static_cast<unsigned>(std::popcount(bits)); }

constexpr bool matches(unsigned code, unsigned mask, unsigned value) {
  return (code & mask) == value;
}

void take(InstructionCost& cost, unsigned cycles) {
  cost.cycles = static_cast<std::uint8_t>(cycles);
}

void move_one(InstructionCost& cost, bool loads) {
  cost.moves_one = true;
  cost.loads = loads;
  take(cost, loads ? 2 : 1);
}

void move_many(InstructionCost& cost, bool loads, unsigned words) {
  cost.loads = loads;
  take(cost, 1 + words);
}

void divide(InstructionCost& cost, unsigned cycles) {
  cost.divides = true;
  take(cost, cycles);
}

void judge_short(InstructionCost& cost, unsigned code) {
  if (matches(code, 0xF800, 0x4800)) return move_one(cost, true);  // A load from the literal pool.
  if (matches(code, 0xF000, 0x5000)) return move_one(cost, (code >> 9U & 7U) >= 3);
  const bool by_offset = matches(code, 0xE000, 0x6000) || matches(code, 0xF000, 0x8000) ||
                         matches(code, 0xF000, 0x9000);
  if (by_offset) return move_one(cost, (code & 0x0800U) != 0);
  if (matches(code, 0xF600, 0xB400)) {  // PUSH, POP
    return move_many(cost, (code & 0x0800U) != 0, ones(code & 0x1FFU));
  }
  if (matches(code, 0xF000, 0xC000)) {  // STM, LDM
    return move_many(cost, (code & 0x0800U) != 0, ones(code & 0xFFU));
  }
}

std::uint8_t single(unsigned four, unsigned one) {
  return static_cast<std::uint8_t>((four & 0xFU) << 1U | (one & 1U));
}

void judge_float_arithmetic(InstructionCost& cost, unsigned first, unsigned second) {
  const unsigned kind = first >> 4U & 0xBU;
  const std::uint8_t d = single(second >> 12U, first >> 6U);
  const std::uint8_t n = single(first, second >> 7U);
  const std::uint8_t m = single(second, second >> 5U);
  cost.result = d;
  cost.operands = {n, m, InstructionCost::kNone};
  const bool adds_product = kind == 0 || kind == 1 || kind == 9 || kind == 10;
  if (adds_product) {
    cost.operands[2] = d;
    return take(cost, kFloatMultiplyAdd);
  }
  if (kind == 8) return divide(cost, kFloatDivision);
  if (kind != 11) return;
  // These instructions have one operand, m. A comparison also reads d, and writes only flags.
  cost.operands[0] = InstructionCost::kNone;
  const unsigned which = first & 0xFU;
  if (which == 1 && (second & 0xC0U) == 0xC0U) return divide(cost, kFloatDivision);  // VSQRT
  if (which == 4 || which == 5) {
    cost.operands[0] = d;
    cost.result = InstructionCost::kNone;
  }
}

void judge_float_move(InstructionCost& cost, unsigned first, unsigned second) {
  const bool loads = (first & 0x10U) != 0;
  const bool is_wide = (second & 0x100U) != 0;
  if (matches(first, 0xFFE0, 0xEC40)) return take(cost, 2);  // Two registers of the core.
  const bool one = matches(first, 0x0120, 0x0100);
  if (!one || is_wide) return move_many(cost, loads, one ? 2 : second & 0xFFU);
  move_one(cost, loads);
  take(cost, 2);  // The cost applies to VSTR, too.
  if (!loads) cost.operands[0] = single(second >> 12U, first >> 6U);
}

void judge_long(InstructionCost& cost, unsigned first, unsigned second) {
  const bool loads = (first & 0x10U) != 0;
  if (matches(first, 0xFE40, 0xE800)) return move_many(cost, loads, ones(second));
  // Load or store of two registers, exclusive access, or a table of branches.
  if (matches(first, 0xFE40, 0xE840)) {
    const bool one = matches(first, 0xFF60, 0xE840);
    return move_many(cost, loads, one ? 1 : 2);
  }
  if (matches(first, 0xEF00, 0xEE00)) {
    if ((second & 0x10U) == 0) judge_float_arithmetic(cost, first, second);
    return;  // Otherwise a move between a register of the core and one of the unit: 1 cycle.
  }
  if (matches(first, 0xEE00, 0xEC00)) return judge_float_move(cost, first, second);
  if (matches(first, 0xFE00, 0xF800)) return move_one(cost, loads);
  if (matches(first, 0xFF80, 0xFB00)) return take(cost, (second & 0xF000U) == 0xF000U ? 1 : 2);
  if (matches(first, 0xFFD0, 0xFB90)) return divide(cost, kDivision);  // SDIV, UDIV
}

}  // namespace

InstructionCost cost_of(std::uint32_t address, std::span<const std::uint8_t> code) {
  InstructionCost cost;
  cost.address = address;
  cost.size = static_cast<std::uint8_t>(code.size());
  const auto half = [&code](std::size_t place) {
    return static_cast<unsigned>(code[place]) | static_cast<unsigned>(code[place + 1]) << 8U;
  };
  if (code.size() == 2) {
    judge_short(cost, half(0));
  } else {
    judge_long(cost, half(0), half(2));
  }
  return cost;
}

}  // namespace machine
