// Tests the model of the core's cycles on code whose cycles the manuals give.

#include "tests/target/machine/probe/support.hpp"

namespace probe {
namespace {

constexpr Word kCounter = 0xE000'1000, kWarm = 3;

Word cycles() { return at(kCounter + 4); }

/// Runs the code several times, and prints the cycles of the last run, when its lines are in the
/// cache. The result includes 1 cycle for the store that ends the counting.
void tell_cycles(const char* name, Routine code) {
  Word spent = 0;
  for (Word run = 0; run < kWarm; ++run) {
    const Word before = cycles();
    code();
    spent = cycles() - before;
  }
  say(name, spent);
}

// The code may use r0 to r3 and s0 to s3.
#define TELL_CYCLES(name, code)                                                                  \
  tell_cycles(name, [] {                                                                         \
    asm volatile(                                                                                \
        "movw r4, #0x1000\n movt r4, #0xE000\n movs r5, #1\n movs r6, #0\n .balign 16\n"         \
        "str r5, [r4]\n" code "\n str r6, [r4]\n" ::                                             \
            : "r0", "r1", "r2", "r3", "r4", "r5", "r6", "s0", "s1", "s2", "s3", "cc", "memory"); \
  })

}  // namespace

void try_cycles() {
  TELL_CYCLES("nothing", "");
  TELL_CYCLES("arithmetic", "adds r0, r1, r2\n mul r0, r1, r2\n mla r0, r1, r2, r1");
  TELL_CYCLES("loads", "mov r3, sp\n ldr r0, [r3]\n ldr r1, [r3, #4]\n ldr r2, [r3, #8]");
  TELL_CYCLES("load_apart", "mov r3, sp\n ldr r0, [r3]\n mov r1, r1\n ldr r2, [r3, #8]");
  TELL_CYCLES("many", "push {r0, r1, r2}\n pop {r0, r1, r2}");
  TELL_CYCLES("divisions",
              "movs r1, #3\n udiv r0, r1, r1\n vdiv.f32 s0, s1, s2\n vsqrt.f32 s0, s1");
  TELL_CYCLES("late_result", "vadd.f32 s0, s1, s2\n vmul.f32 s3, s0, s1");
  TELL_CYCLES("early_result", "vadd.f32 s0, s1, s2\n mov r0, r0\n vmul.f32 s3, s0, s1");
  TELL_CYCLES("loop", "movs r0, #10\n 1: subs r0, r0, #1\n bne 1b");
  TELL_CYCLES("short_row", ".rept 40\n mov.w r0, r0\n .endr");
  // Longer than the 64 lines of the cache, so that each line has to be read: ahead, while the line
  // before it runs.
  TELL_CYCLES("long_row", ".rept 1999\n mov.w r0, r0\n .endr");
  // Two jumps between lines that are not adjacent, and that all fit into the 64 lines.
  TELL_CYCLES("jumps", "b 2f\n .balign 64\n 1: b 3f\n .balign 64\n 2: b 1b\n .balign 64\n 3: nop");
  end(true);
}

}  // namespace probe
