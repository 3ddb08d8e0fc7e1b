// Scenarios of the watchdog, the memories and the core's own peripherals.

#include <initializer_list>

#include "tests/target/machine/probe/support.hpp"

namespace probe {

/// Feeds the watchdog at 20 ms with a timeout of 32 ms, and then stops feeding it.
void try_watchdog() {
  constexpr Word kReloadValue = 255, kStatus = kWatchdog + 0x0C, kCause = kRcc + 0x74;
  run_at_168_mhz();
  enable_clocks();
  say("cause", at(kCause) >> 24U);
  if ((at(kCause) & 1U << 29U) != 0) return;
  at(kCause) = 1U << 24U;
  at(kGpioA) = 0xA800'0001;
  at(kWatchdog + 0x08) = 1;  // Without the key, the write has no effect: the register stays 0xFFF.
  say("protected", at(kWatchdog + 0x08));
  at(kWatchdog) = 0x5555;
  at(kWatchdog + 0x04) = 0;
  at(kWatchdog + 0x08) = kReloadValue;
  say("updating", at(kStatus));
  wait_for(kStatus, 3, 0);
  at(kWatchdog) = 0xCCCC;
  for (int i = 0; i < 3; ++i) {
    wait_us(20'000);
    at(kWatchdog) = 0xAAAA;
  }
  at(kGpioA + 0x18) = 1;
  say("fed", 3);
  for (;;) asm volatile("wfi");
}

/// Prints where memory begins and ends, the chip's identity, and its cycles in comparison with a
/// timer.
void try_memory() {
  run_at_168_mhz();
  enable_clocks();
  for (const Word address : {0x1000'0000U, 0x1000'FFFCU, 0x2000'8000U, 0x2001'FF00U}) {
    at(address) = address ^ 0x5A5A'5A5AU;
    say("kept", at(address) == (address ^ 0x5A5A'5A5AU) ? 1 : 0);
  }
  for (const Word address : {0x2002'0000U, 0x2002'FFFCU, 0x1001'0000U}) {
    say("beyond", read_faults(address) ? 1 : 0, write_faults(address, 1) ? 1 : 0);
  }
  say("flash_kb", at(0x1FFF'7A20) >> 16U);
  say("code", at(0xE004'2000) & 0xFFFU);
  for (const Word kib : {256U, 512U, 1024U}) {
    const Word end = 0x0800'0000 + kib * 1024;
    say("flash_end", read_faults(end - 4) ? 1 : 0, kib < 1024 && read_faults(end) ? 1 : 0);
  }
  for (const Word offset : {0U, 4U, 8U}) say("unique", at(0x1FFF'7A10 + offset));
  constexpr Word kDebugControl = 0xE000'EDFC, kCycles = 0xE000'1004, kCycleControl = 0xE000'1000;
  at(kCycleControl) = 1;
  say("without_tracing", at(kCycles));
  at(kDebugControl) = 1U << 24U;
  at(kCycleControl) = 1;
  at(kCycles) = 0;
  start_clock();
  wait_us(5000);
  say("cycles", at(kCycles), clock_us());
}

/// Watches a word of memory, of which the test script flips a bit.
void try_flip() {
  run_at_168_mhz();
  enable_clocks();
  volatile Word& word = at(0x2001'F010);
  word = 0;
  for (Word tries = 10'000'000; word == 0 && tries > 0; --tries) {
  }
  say("flipped", word);
}

}  // namespace probe
