#include "tests/target/machine/probe/support.hpp"

namespace probe {
namespace {

constexpr Word kStatus = kUsart1, kData = kUsart1 + 0x04, kRate = kUsart1 + 0x08;
constexpr Word kControl = kUsart1 + 0x0C;
constexpr Word kOverrun = 1U << 3U, kReceived = 1U << 5U, kComplete = 1U << 6U, kEmpty = 1U << 7U;
constexpr unsigned kInterrupt = 37;
constexpr char kEnd = 4;

volatile Word bytes, sum, overruns, framing_errors;
volatile bool over;
volatile Word lines;

void start(Routine handler) {
  run_at_168_mhz();
  enable_clocks();
  on_interrupt(kInterrupt, handler);
  at(kRate) = 729;  // Divider for 115,226 baud at 84 MHz.
  at(kControl) = 1U << 13U | kReceived | 1U << 3U | 1U << 2U;
}

void send(const char* text) {
  for (; *text != '\0'; ++text) {
    wait_for(kStatus, kEmpty, kEmpty);
    at(kData) = static_cast<Word>(*text);
  }
}

void take() {
  const Word status = at(kStatus);
  if ((status & (kOverrun | kReceived)) == 0) return;
  const auto byte = static_cast<char>(at(kData));
  if ((status & kOverrun) != 0) overruns = overruns + 1;
  if ((status & 2U) != 0) framing_errors = framing_errors + 1;
  bytes = bytes + 1;
  sum = sum * 31 + static_cast<Word>(byte);
  if (byte == kEnd) over = true;
  if (byte == '\n' && !over) lines = lines + 1;
}

}  // namespace

/// Receives bytes in the interrupt until the end mark or for half a second; sends meanwhile.
void try_usart() {
  start(take);
  send("all of this goes out");
  wait_for(kStatus, kComplete, kComplete);
  say("complete", at(kStatus) & kComplete);
  for (int i = 0; i < 500 && !over; ++i) wait_us(1000);
  say("bytes", bytes, sum);
  say("errors", overruns, framing_errors);
}

/// Reads a byte only every millisecond: most of the bytes that arrive every 87 µs are lost.
void try_usart_late() {
  start([] {});
  at(kControl) = at(kControl) & ~kReceived;
  for (int i = 0; i < 30; ++i) {
    wait_us(1000);
    take();
  }
  say("bytes", bytes, sum);
  say("errors", overruns, framing_errors);
}

/// Answers each line as a controller does that takes 2 ms per line.
void try_lines() {
  start(take);
  for (Word answered = 0; !over || answered != lines;) {
    if (answered == lines) {
      asm volatile("wfi");
      continue;
    }
    wait_us(2000);
    send("ok\n");
    ++answered;
  }
  send("bye\n");
  wait_for(kStatus, kComplete, kComplete);
  say("bytes", bytes, sum);
  say("errors", overruns, framing_errors);
}

}  // namespace probe
