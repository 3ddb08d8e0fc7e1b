#include <initializer_list>

#include "tests/target/machine/probe/support.hpp"

namespace probe {
namespace {

constexpr Word kModer = kGpioA, kSetReset = kGpioA + 0x18;
constexpr Word kUpdateInterrupt2 = 28, kUpdateInterrupt3 = 29, kUpdateInterrupt1 = 25;
constexpr Word kInterrupt5 = 50;
constexpr Word kTurns = 400;

volatile Word turns[3];
volatile Word seen_count;

/// Toggles pin A`index`, so that each interrupt is an edge in the trace.
template <Word kTimer, Word kIndex>
void turn_over() {
  at(kTimer + kSr) = 0;
  const Word turn = turns[kIndex];
  at(kSetReset) = turn % 2 == 0 ? 1U << kIndex : 0x1'0000U << kIndex;
  turns[kIndex] = turn + 1;
  if (turn + 1 >= kTurns) at(kTimer + kCr1) = 0;
}

void start(Word timer, Word prescaler, Word reload, Word control) {
  at(timer + kDier) = 0;
  at(timer + kPsc) = prescaler;
  at(timer + kArr) = reload;
  at(timer + kEgr) = 1;
  at(timer + kSr) = 0;
  at(timer + kDier) = 1;
  at(timer + kCr1) = control;
}

void prepare() {
  run_at_168_mhz();
  enable_clocks();
  at(kModer) = 0xA800'0015;
}

}  // namespace

/// Runs three timers with different clocks and periods together: 10 µs, 13.5 µs and 25 µs.
void try_periods() {
  prepare();
  on_interrupt(kUpdateInterrupt2, turn_over<kTim2, 0>);
  on_interrupt(kUpdateInterrupt3, turn_over<kTim3, 1>);
  on_interrupt(kUpdateInterrupt1, turn_over<kTim1, 2>);
  start(kTim2, 0, 839, 1);   // 84 MHz
  start(kTim3, 6, 161, 1);   // 12 MHz
  start(kTim1, 3, 1049, 1);  // 42 MHz
  while (turns[0] < kTurns || turns[1] < kTurns || turns[2] < kTurns) {
  }
  say("turns", turns[0], turns[1]);
}

/// Makes one pulse of 100 µs, then one of 50 µs.
void try_one_pulse() {
  prepare();
  on_interrupt(kUpdateInterrupt2, [] {
    at(kTim2 + kSr) = 0;
    at(kSetReset) = 1U << 16U;
    turns[0] = turns[0] + 1;
  });
  for (const Word length : {8400U, 4200U}) {
    turns[0] = 0;
    start(kTim2, 0, length - 1, 0);
    at(kSetReset) = 1;
    at(kTim2 + kCr1) = 9;
    wait_us(1000);
    say("pulses", turns[0]);
    say("stopped", at(kTim2 + kCr1), at(kTim2 + kCnt));
  }
}

/// Runs compare interrupts of a free-running counter, each 5000 clocks after the last.
void try_compare() {
  prepare();
  on_interrupt(kInterrupt5, [] {
    at(kTim5 + kSr) = ~2U;
    const Word turn = turns[0];
    at(kSetReset) = turn % 2 == 0 ? 1U : 1U << 16U;
    seen_count = at(kTim5 + kCnt);
    at(kTim5 + kCcr1) = at(kTim5 + kCcr1) + 5000;
    turns[0] = turn + 1;
  });
  at(kTim5 + kCnt) = ~0U - 20'000;  // The counter also passes its widest value.
  at(kTim5 + kCcr1) = ~0U - 15'000;
  at(kTim5 + kDier) = 2;
  at(kTim5 + kCr1) = 1;
  while (turns[0] < 20) {
  }
  say("compared", turns[0], seen_count);
}

/// Sets a reload value below the count. It applies immediately, so that the counter continues to
/// its widest value. With preload it waits for the next overflow.
void try_late_reload() {
  prepare();
  for (const Word control : {0x01U, 0x81U}) {
    start(kTim3, 0, 19'999, control);
    on_interrupt(kUpdateInterrupt3, [] {
      at(kTim3 + kSr) = 0;
      at(kTim3 + kCr1) = 0;
      seen_count = at(kTim5 + kCnt);
    });
    at(kTim5 + kPsc) = 0;
    at(kTim5 + kArr) = ~0U;
    at(kTim5 + kEgr) = 1;
    at(kTim5 + kCr1) = 1;
    while (at(kTim3 + kCnt) < 10'000) {
    }
    at(kTim3 + kArr) = 999;
    seen_count = 0;
    while (seen_count == 0) {
    }
    say("overflow", control, seen_count);
    at(kTim3 + kDier) = 0;
  }
}

/// Runs TIM1 channel 1 as for the beam: 20 kHz at 168 MHz, preloaded compare, MOE of the break
/// register.
void try_pwm() {
  prepare();
  at(kTim1 + kArr) = 8399;
  at(kTim1 + kCcmr1) = 0x68;
  at(kTim1 + kCcer) = 1;
  at(kTim1 + kEgr) = 1;
  at(kTim1 + kCr1) = 1;
  at(kTim1 + kCcr1) = 2100;  // The output is still off.
  wait_us(200);
  at(kTim1 + kBdtr) = 1U << 15U;
  for (const Word compare : {0U, 4200U, 8400U, 2100U}) {
    wait_us(333);
    at(kSetReset) = 1;
    at(kTim1 + kCcr1) = compare;
    at(kSetReset) = 1U << 16U;
  }
  wait_us(333);
  at(kTim1 + kBdtr) = 0;
}

}  // namespace probe
