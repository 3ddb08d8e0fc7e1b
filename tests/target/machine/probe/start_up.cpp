// Vectors, memory, semihosting (Arm, "Semihosting for AArch32") and the choice of a scenario by
// the last word of the command line.

#include <cstddef>
#include <cstdint>

#include "tests/target/machine/probe/support.hpp"

extern "C" {
extern std::uint32_t stack_top, data_load, data_begin, data_end, bss_begin, bss_end;
[[noreturn]] void reset();
void fault_at(std::uint32_t* frame);
[[gnu::naked]] void fault();
void interrupt();
// The compiler generates calls of memset for loops that fill memory.
void* memset(void* at, int value, std::size_t size);
}

namespace probe {
namespace {

constexpr unsigned kCoreVectors = 16, kInterrupts = 82;
constexpr Word kConfigurableFault = 0xE000'ED28, kCoprocessors = 0xE000'ED88;
constexpr Word kInterruptEnable = 0xE000'E100;

struct Scenario {
  const char* name;
  Routine run;
};
constexpr Scenario kScenarios[] = {
    {"clocks", try_clocks},
    {"edges", try_edges},
    {"inputs", try_inputs},
    {"periods", try_periods},
    {"one_pulse", try_one_pulse},
    {"compare", try_compare},
    {"pwm", try_pwm},
    {"late_reload", try_late_reload},
    {"flash", try_flash},
    {"flash_keys", try_flash_keys},
    {"flash_cut", try_flash_cut},
    {"watchdog", try_watchdog},
    {"memory", try_memory},
    {"flip", try_flip},
    {"usart", try_usart},
    {"usart_late", try_usart_late},
    {"lines", try_lines},
    {"can_loop", try_can_loop},
    {"can_bus", try_can_bus},
    {"can_off", try_can_off},
    {"cycles", try_cycles},
};

Routine handlers[kInterrupts];
volatile bool fault_expected, fault_seen;

Word semihosting(Word operation, const void* argument) {
  register Word r0 asm("r0") = operation;
  register const void* r1 asm("r1") = argument;
  asm volatile("bkpt 0xab" : "+r"(r0) : "r"(r1) : "memory");
  return r0;
}

void write_text(const char* text) { semihosting(0x04, text); }

void write_number(Word value) {
  char digits[12];
  char* first = digits + sizeof digits;
  *--first = '\0';
  do *--first = static_cast<char>('0' + value % 10);
  while ((value /= 10) != 0);
  *--first = ' ';
  write_text(first);
}

bool ends_with(const char* text, const char* word) {
  const char* last = text;
  for (const char* at = text; *at != '\0'; ++at) {
    if (*at == ' ') last = at + 1;
  }
  while (*last != '\0' && *last == *word) ++last, ++word;
  return *last == '\0' && *word == '\0';
}

void run_scenario() {
  char line[128];
  struct {
    char* text;
    Word size;
  } block{line, sizeof line};
  semihosting(0x15, &block);
  for (const Scenario& scenario : kScenarios) {
    if (ends_with(line, scenario.name)) return scenario.run();
  }
  write_text("no such scenario\n");
  end(false);
}

}  // namespace

void say(const char* name) {
  write_text(name);
  write_text("\n");
}
void say(const char* name, Word value) {
  write_text(name);
  write_number(value);
  write_text("\n");
}
void say(const char* name, Word first, Word second) {
  write_text(name);
  write_number(first);
  write_number(second);
  write_text("\n");
}

void end(bool good) {
  const Word reason = good ? 0x20026 : 0x20023;
  for (;;) semihosting(0x18, reinterpret_cast<const void*>(reason));
}

void on_interrupt(unsigned number, Routine handler) {
  handlers[number] = handler;
  at(kInterruptEnable + number / 32 * 4) = 1U << number % 32;
}

bool read_faults(Word address) {
  fault_seen = false;
  fault_expected = true;
  [[maybe_unused]] const Word value = at(address);
  asm volatile("dsb" ::: "memory");
  fault_expected = false;
  return fault_seen;
}

bool write_faults(Word address, Word value) {
  fault_seen = false;
  fault_expected = true;
  at(address) = value;
  asm volatile("dsb" ::: "memory");
  fault_expected = false;
  return fault_seen;
}

}  // namespace probe

extern "C" void* memset(void* at, int value, std::size_t size) {
  auto* const bytes = static_cast<volatile unsigned char*>(at);
  for (std::size_t i = 0; i < size; ++i) bytes[i] = static_cast<unsigned char>(value);
  return at;
}

/// Skips an access that was expected to fault; any other fault ends the program.
extern "C" void fault_at(std::uint32_t* frame) {
  using namespace probe;
  if (!fault_expected) {
    say("fault", at(kConfigurableFault), frame[6]);
    end(false);
  }
  fault_seen = true;
  at(kConfigurableFault) = at(kConfigurableFault);
  const auto instruction = *reinterpret_cast<const std::uint16_t*>(frame[6]);
  frame[6] += instruction >> 11U >= 0x1DU ? 4 : 2;
}

extern "C" void fault() { asm volatile("mov r0, sp\n b fault_at"); }

extern "C" void interrupt() {
  std::uint32_t number = 0;
  asm volatile("mrs %0, ipsr" : "=r"(number));
  probe::handlers[number - probe::kCoreVectors]();
}

extern "C" void reset() {
  probe::at(probe::kCoprocessors) = probe::at(probe::kCoprocessors) | 0xFU << 20U;
  asm volatile("dsb; isb" ::: "memory");
  const std::uint32_t* from = &data_load;
  for (std::uint32_t* to = &data_begin; to < &data_end;) *to++ = *from++;
  for (volatile std::uint32_t* to = &bss_begin; to < &bss_end;) *to++ = 0;
  probe::run_scenario();
  probe::end(true);
}

namespace {

struct Vectors {
  const void* stack;
  probe::Routine core[probe::kCoreVectors - 1];
  probe::Routine interrupts[probe::kInterrupts];
};

constexpr Vectors make_vectors() {
  Vectors vectors{&stack_top, {reset}, {}};
  for (int i = 1; i < 15; ++i) vectors.core[i] = fault;
  for (auto& vector : vectors.interrupts) vector = interrupt;
  return vectors;
}

}  // namespace

[[gnu::section(".vectors"), gnu::used]] constinit const Vectors kVectors = make_vectors();
