/// What the compiler calls where 64 bits become a float: with the floating-point unit, instead of
/// the compiler's own, which computes with whole numbers: shorter and quicker, the same bits.
/// And the length of a text, one by one: names and messages are short, and so is this.

#include <cstddef>

#include "planner/base/truncate.hpp"

// The names and registers are those of the run-time ABI for the Arm architecture.
#define KERFLINE_OF_THE_COMPILER __attribute__((pcs("aapcs"), used, noinline))
// Else the compiler knows the loop again, and calls what it is.
#define KERFLINE_AS_WRITTEN __attribute__((used, optimize("no-tree-loop-distribute-patterns")))

extern "C" {
KERFLINE_OF_THE_COMPILER float unsigned_to_float(std::uint64_t value) __asm__("__aeabi_ul2f");
KERFLINE_OF_THE_COMPILER float signed_to_float(std::int64_t value) __asm__("__aeabi_l2f");
KERFLINE_AS_WRITTEN std::size_t length_of_text(const char* text) __asm__("strlen");
}

float unsigned_to_float(std::uint64_t value) { return cnc::float_of_bits(value); }

float signed_to_float(std::int64_t value) {
  const auto bits = static_cast<std::uint64_t>(value);
  return value < 0 ? -unsigned_to_float(0U - bits) : unsigned_to_float(bits);
}

std::size_t length_of_text(const char* text) {
  std::size_t length = 0;
  while (text[length] != '\0') ++length;
  return length;
}
