#include "tests/target/machine/probe/support.hpp"

namespace probe {
namespace {

constexpr Word kMode = 0x00, kType = 0x04, kPull = 0x0C, kInput = 0x10, kSetReset = 0x18;

}  // namespace

/// Writes pin A0 a hundred times, and prints TIM2's count with each. Then drives a pin in all ways.
void try_edges() {
  run_at_168_mhz();
  enable_clocks();
  at(kTim2 + kCr1) = 1;
  at(kGpioA + kMode) = 0xA800'0001;
  for (Word i = 0; i < 100; ++i) {
    const Word before = at(kTim2 + kCnt);
    at(kGpioA + kSetReset) = i % 2 == 0 ? 1U : 1U << 16U;
    say("edge", before, at(kTim2 + kCnt));
  }
  at(kGpioB + kSetReset) = 1U << 5U | 1U << 21U;  // Set takes precedence over reset.
  at(kGpioB + kType) = 1U << 6U;
  at(kGpioB + kSetReset) = 1U << 6U;
  at(kGpioB + kMode) = 0x280U | 1U << 10U | 1U << 12U | 2U << 14U;
  at(kGpioB + kSetReset) = 1U << 22U;
  say("read_back", at(kGpioB + kInput));
}

/// Prints the changing levels, with TIM2's count.
void try_inputs() {
  run_at_168_mhz();
  enable_clocks();
  at(kGpioB + kPull) = 0x100U | 1U << 2U;  // B1 with a pull-up.
  at(kTim2 + kPsc) = 83;
  at(kTim2 + kEgr) = 1;
  at(kTim2 + kCr1) = 1;
  Word last = ~0U;
  while (at(kTim2 + kCnt) < 10'000) {
    const Word now = at(kGpioB + kInput) & 7U;
    if (now != last) say("levels", now, at(kTim2 + kCnt));
    last = now;
  }
}

}  // namespace probe
