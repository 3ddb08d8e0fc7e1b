#include <initializer_list>

#include "tests/target/machine/probe/support.hpp"

namespace probe {
namespace {

constexpr Word kKey = kFlash + 0x04, kState = kFlash + 0x0C, kCommand = kFlash + 0x10;
constexpr Word kBusy = 1U << 16U, kLock = 1U << 31U, kByWord = 2U << 8U;
constexpr Word kProgram = 1, kErase = 2, kStart = 1U << 16U, kEndInterrupt = 1U << 24U;
constexpr Word kErrors = 0xF2;
// Sector 2, with its first address and its size.
constexpr Word kSector = 2, kFirst = 0x0800'8000, kSize = 0x4000;

void unlock() {
  at(kKey) = 0x4567'0123;
  at(kKey) = 0xCDEF'89AB;
}

/// Writes a value, and returns the error flags, which it clears.
Word errors_of(Word control, Word address, Word value) {
  at(kCommand) = control;
  at(address) = value;
  const Word errors = at(kState) & kErrors;
  wait_for(kState, kBusy, 0);
  at(kState) = kErrors;
  return errors;
}

void erase_sector(Word more = 0) {
  at(kCommand) = kErase | kSector << 3U | kByWord | more;
  at(kCommand) = at(kCommand) | kStart;
}

}  // namespace

/// Tests locks, sizes, the effect of programming and erasing on a word, and the time of each.
void try_flash() {
  run_at_168_mhz();
  enable_clocks();
  say("locked", errors_of(kProgram | kByWord, kFirst, 1), at(kFirst));
  unlock();
  say("unlocked", at(kCommand) / kLock);
  say("no_program", errors_of(kByWord, kFirst, 1), at(kFirst));
  say("wrong_size", errors_of(kProgram, kFirst, 1), at(kFirst));
  for (const Word address : {kFirst - 4, kFirst, kFirst + kSize - 4, kFirst + kSize}) {
    say("programmed", errors_of(kProgram | kByWord, address, 0x0F0F'0F0F), at(address));
  }
  errors_of(kProgram | kByWord, kFirst, 0xFFFF'0000);
  say("again", at(kFirst));
  start_clock();
  at(kCommand) = kProgram | kByWord;
  const Word before = clock_us();
  at(kFirst + 4) = 0;
  at(kFirst + 8) = 0;  // While the first operation is in progress.
  say("while_busy", at(kState) & kErrors, at(kFirst + 8));
  wait_for(kState, kBusy, 0);
  say("program_us", clock_us() - before);
  at(kState) = kErrors;
  static volatile Word ended_us;
  constexpr unsigned kInterrupt = 4;
  on_interrupt(kInterrupt, [] {
    ended_us = clock_us();
    at(kState) = 1;
  });
  ended_us = 0;
  const Word begun_us = clock_us();
  erase_sector(kEndInterrupt);
  say("erasing", (at(kState) & kBusy) / kBusy);
  while (ended_us == 0) asm volatile("wfi" ::: "memory");
  say("erase_us", ended_us - begun_us);
  for (const Word address : {kFirst - 4, kFirst, kFirst + kSize - 4, kFirst + kSize}) {
    say("erased", at(address));
  }
  at(kCommand) = kLock;
  say("locked", errors_of(kProgram | kByWord, kFirst, 1), at(kFirst));
}

/// Unlocks with one wrong key, then with the right keys, which no longer work.
void try_flash_keys() {
  at(kKey) = 0x4567'0124;
  unlock();
  say("locked", at(kCommand) / kLock);
}

/// Programs eight words into an empty sector and erases it: nine operations, each reported when it
/// is done. A sector that is not empty is printed and left unchanged.
void try_flash_cut() {
  run_at_168_mhz();
  bool empty = true;
  for (Word i = 0; i < 8; ++i) {
    const Word word = at(kFirst + 4 * i);
    say("word", i, word);
    empty = empty && word == ~0U;
  }
  if (!empty) return;
  unlock();
  for (Word i = 0; i < 8; ++i) {
    errors_of(kProgram | kByWord, kFirst + 4 * i, 0x1234'5678U + i);
    say("done", i + 1);
  }
  erase_sector();
  wait_for(kState, kBusy, 0);
  say("done", 9);
}

}  // namespace probe
