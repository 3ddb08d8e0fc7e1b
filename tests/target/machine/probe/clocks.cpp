#include "tests/target/machine/probe/support.hpp"

namespace probe {
namespace {

constexpr Word kCr = kRcc, kPllCfgr = kRcc + 0x04, kCfgr = kRcc + 0x08, kCsr = kRcc + 0x74;
constexpr Word kAhb1Enable = kRcc + 0x30, kApb1Enable = kRcc + 0x40, kApb2Enable = kRcc + 0x44;

void enable(Word address, Word bits) { at(address) = at(address) | bits; }

}  // namespace

bool wait_for(Word address, Word mask, Word wanted, Word tries) {
  while (tries-- > 0) {
    if ((at(address) & mask) == wanted) return true;
  }
  return false;
}

bool run_at_168_mhz() {
  enable(kApb1Enable, 1U << 28U);
  enable(kPwr, 1U << 14U);
  enable(kCr, 1U << 16U);
  if (!wait_for(kCr, 1U << 17U, 1U << 17U)) return false;
  at(kPllCfgr) = 8U | 336U << 6U | 1U << 22U | 7U << 24U;  // 8 MHz / 8 * 336 / 2.
  enable(kCr, 1U << 24U);
  if (!wait_for(kCr, 1U << 25U, 1U << 25U)) return false;
  at(kFlash) = 0x705;
  at(kCfgr) = 5U << 10U | 4U << 13U | 2U;
  return wait_for(kCfgr, 0xC, 0x8);
}

void enable_clocks() {
  enable(kAhb1Enable, 7);
  enable(kApb1Enable, 1U << 28U | 1U << 25U | 0xBU);
  enable(kApb2Enable, 1U << 4U | 1U);
}

void wait_us(Word microseconds) {
  static volatile bool over;
  over = false;
  at(kTim5 + kCr1) = 0;
  at(kTim5 + kDier) = 0;
  at(kTim5 + kPsc) = 83;
  at(kTim5 + kArr) = microseconds - 1;
  at(kTim5 + kEgr) = 1;
  at(kTim5 + kSr) = 0;
  constexpr unsigned kInterrupt = 50;
  on_interrupt(kInterrupt, [] {
    at(kTim5 + kSr) = 0;
    over = true;
  });
  at(kTim5 + kDier) = 1;
  at(kTim5 + kCr1) = 9;
  // Interrupts are masked between the check and the sleep; an interrupt ends the sleep
  // nevertheless.
  for (;;) {
    asm volatile("cpsid i" ::: "memory");
    if (over) break;
    asm volatile("wfi\n cpsie i\n isb" ::: "memory");
  }
  asm volatile("cpsie i" ::: "memory");
  at(kTim5 + kDier) = 0;
}

void start_clock() {
  at(kTim2 + kCr1) = 0;
  at(kTim2 + kPsc) = 83;
  at(kTim2 + kArr) = ~0U;
  at(kTim2 + kEgr) = 1;
  at(kTim2 + kCr1) = 1;
}

/// Checks that a port without its clock reads 0, that the crystal takes its time, and that TIM5
/// counts at the inner oscillator's 16 MHz before and at 84 MHz after the switch, which the core's
/// own counter confirms.
void try_clocks() {
  say("cause", at(kCsr) >> 24U);
  say("without_clock", at(kGpioA));
  enable_clocks();
  say("with_clock", at(kGpioA));
  at(kTim5 + kCr1) = 1;
  say("ready", run_at_168_mhz() ? 1 : 0, at(kTim5 + kCnt));
  at(kCsr) = 1U << 24U;
  say("forgotten_cause", at(kCsr) >> 24U);
  wait_us(1000);
  constexpr Word kResetControl = 0xE000'ED0C;
  static volatile Word& again = at(0x2001'F000);  // Reset preserves memory.
  if (again != 0x600D) {
    again = 0x600D;
    at(kResetControl) = 0x05FA'0004;
    for (;;) {
    }
  }
}

}  // namespace probe
