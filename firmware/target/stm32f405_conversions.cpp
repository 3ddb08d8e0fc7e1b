/// What the compiler calls where 64 bits become a float: with the floating-point unit, instead of
/// the compiler's own, which computes with whole numbers: shorter and quicker, the same bits.

#include "planner/base/truncate.hpp"

// The names and registers are those of the run-time ABI for the Arm architecture.
#define KERFLINE_OF_THE_COMPILER __attribute__((pcs("aapcs"), used, noinline))

extern "C" {
KERFLINE_OF_THE_COMPILER float unsigned_to_float(std::uint64_t value) __asm__("__aeabi_ul2f");
KERFLINE_OF_THE_COMPILER float signed_to_float(std::int64_t value) __asm__("__aeabi_l2f");
}

float unsigned_to_float(std::uint64_t value) { return cnc::float_of_bits(value); }

float signed_to_float(std::int64_t value) {
  const auto bits = static_cast<std::uint64_t>(value);
  return value < 0 ? -unsigned_to_float(0U - bits) : unsigned_to_float(bits);
}
