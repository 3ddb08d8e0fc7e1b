#include "tests/target/machine/probe/support.hpp"

namespace probe {
namespace {

constexpr Word kMaster = kCan1, kMasterStatus = kCan1 + 0x04, kTransmit = kCan1 + 0x08;
constexpr Word kFifo = kCan1 + 0x0C, kInterrupts = kCan1 + 0x14, kErrors = kCan1 + 0x18;
constexpr Word kTiming = kCan1 + 0x1C, kMailbox = kCan1 + 0x180, kMail = kCan1 + 0x1B0;
constexpr Word kFilterMaster = kCan1 + 0x200, kFilterWide = kCan1 + 0x20C;
constexpr Word kFilterActive = kCan1 + 0x21C, kFilterBank = kCan1 + 0x240;
constexpr Word kRecoverAlone = 1U << 6U, kLoop = 1U << 30U;
// A bit of 14 quanta of 6 clocks at 42 MHz.
constexpr Word kTiming500k = 3U << 20U | 8U << 16U | 5U;
constexpr unsigned kReceiveInterrupt = 20, kStatusInterrupt = 22;

volatile Word received, sum, status_interrupts;

/// Joins the bus. Accepts frames whose identifier matches `id` and `mask`, which are filter words.
bool join(Word timing, Word control, Word id = 0, Word mask = 0) {
  at(kMaster) = 1;
  if (!wait_for(kMasterStatus, 3, 1)) return false;
  at(kTiming) = timing;
  at(kFilterWide) = 1;
  at(kFilterBank) = id;
  at(kFilterBank + 4) = mask;
  at(kFilterActive) = 1;
  at(kFilterMaster) = 0x2A1C'0E00;
  at(kInterrupts) = 1U << 15U | 1U << 10U | 1U << 1U;
  at(kMaster) = control;
  return wait_for(kMasterStatus, 3, 0);
}

void prepare() {
  run_at_168_mhz();
  enable_clocks();
  start_clock();
  on_interrupt(kReceiveInterrupt, [] {
    sum = sum * 31 + at(kMail) + at(kMail + 8);
    received = received + 1;
    at(kFifo) = 0x20;
  });
  on_interrupt(kStatusInterrupt, [] {
    status_interrupts = status_interrupts + 1;
    at(kMasterStatus) = 4;
  });
}

/// Puts a frame into the first empty mailbox; returns false if none becomes empty.
bool send(Word id, Word low) {
  if (!wait_for(kTransmit, 1U << 26U, 1U << 26U)) return false;
  at(kMailbox + 4) = 4;
  at(kMailbox + 8) = low;
  at(kMailbox) = id << 21U | 1U;
  return true;
}

}  // namespace

/// Sends fifty frames to itself.
void try_can_loop() {
  prepare();
  say("joined", join(kTiming500k | kLoop, kRecoverAlone) ? 1 : 0);
  Word expected = 0;
  for (Word i = 0; i < 50; ++i) {
    send(0x100 + i, i * 0x0101'0101);
    expected = expected * 31 + ((0x100 + i) << 21U) + i * 0x0101'0101;
  }
  for (int tries = 0; tries < 100 && received < 50; ++tries) wait_us(1000);
  say("received", received, sum - expected);
  say("counters", at(kErrors) >> 16U & 0xFFU, at(kErrors) >> 24U);
}

/// Receives the frames of other nodes with the identifier 0x2A5, and sends three frames.
void try_can_bus() {
  prepare();
  say("joined", join(kTiming500k, kRecoverAlone, 0x2A5U << 21U, 0x7FFU << 21U | 6U) ? 1 : 0);
  for (Word i = 0; i < 3; ++i) send(0x300 + i, i);
  wait_us(20'000);
  say("received", received, sum);
  say("counters", at(kErrors) >> 16U & 0xFFU, at(kErrors) >> 24U);
}

/// Sends one frame that never gets through, because the node is alone or all frames are corrupted.
/// Then leaves bus-off, by initialisation and automatically.
void try_can_off() {
  prepare();
  join(kTiming500k, 0);
  send(0x123, 0xFFFF'FFFF);
  const bool off = wait_for(kErrors, 4, 4, 400'000);
  say("off", off ? 1 : 0, at(kErrors) >> 16U & 0xFFU);
  say("passive", at(kErrors) >> 1U & 1U, at(kErrors) >> 4U & 7U);
  if (!off) return;
  say("interrupts", status_interrupts);
  wait_us(10'000);
  say("still_off", at(kErrors) >> 2U & 1U);
  at(kTransmit) = 0x80;  // Withdraws the frame.
  at(kMaster) = 1;
  wait_for(kMasterStatus, 1, 1);
  Word begun_us = clock_us();
  at(kMaster) = kRecoverAlone;
  wait_for(kErrors, 4, 0);
  say("back_us", clock_us() - begun_us, at(kErrors) >> 16U);
  send(0x123, 0);
  wait_for(kErrors, 4, 4);
  begun_us = clock_us();
  wait_for(kErrors, 4, 0);
  say("back_us", clock_us() - begun_us, at(kErrors) >> 16U);
}

}  // namespace probe
