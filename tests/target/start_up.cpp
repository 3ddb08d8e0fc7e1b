#include "tests/target/start_up.hpp"

#include <cstddef>
#include <cstdint>

#include "planner/base/contract.hpp"

extern "C" {
using Routine = void (*)();
extern std::uint32_t stack_top, data_load, data_begin, data_end, bss_begin, bss_end;
extern std::uint32_t ccm_begin, ccm_end;
extern Routine init_begin[], init_end[];
[[noreturn]] void reset();
[[noreturn]] void fault();
// A call through the table of an abstract class under construction, which never happens.
[[noreturn]] void __cxa_pure_virtual() { fault(); }
}

namespace {

constexpr std::uint32_t kWriteText = 0x04;
constexpr std::uint32_t kExit = 0x18;
constexpr std::uint32_t kApplicationExit = 0x20026;
constexpr std::uint32_t kRunTimeError = 0x20023;

void semihosting(std::uint32_t operation, const void* argument) {
  register std::uint32_t r0 asm("r0") = operation;
  register const void* r1 asm("r1") = argument;
  asm volatile("bkpt 0xab" : "+r"(r0) : "r"(r1) : "memory");
}

[[noreturn]] void end(std::uint32_t reason) {
  for (;;) semihosting(kExit, reinterpret_cast<const void*>(reason));
}

}  // namespace

void write_text(const char* text) { semihosting(kWriteText, text); }

void cnc::contract_failed(const char*, const char*, int) {
  semihosting(kWriteText, "contract failed\n");
  end(kRunTimeError);
}

extern "C" void fault() { end(kRunTimeError); }

extern "C" void reset() {
  auto* const coprocessor_access = reinterpret_cast<volatile std::uint32_t*>(0xE000ED88);
  *coprocessor_access = *coprocessor_access | 0xFU << 20;  // The FPU is off after reset.
  asm volatile("dsb; isb" ::: "memory");
  const std::uint32_t* from = &data_load;
  for (std::uint32_t* to = &data_begin; to < &data_end;) *to++ = *from++;
  for (std::uint32_t* to = &bss_begin; to < &bss_end;) *to++ = 0;
  for (std::uint32_t* to = &ccm_begin; to < &ccm_end;) *to++ = 0;
  for (Routine* routine = init_begin; routine != init_end; ++routine) (*routine)();
  run_on_target();
  end(kApplicationExit);
}

__attribute__((section(".vectors"), used))
const Routine kVectors[16] = {reinterpret_cast<Routine>(&stack_top),
                              reset,
                              fault,
                              fault,
                              fault,
                              fault,
                              fault,
                              nullptr,
                              nullptr,
                              nullptr,
                              nullptr,
                              fault,
                              fault,
                              nullptr,
                              fault,
                              fault};
