#pragma once

// Common functions of the probes: registers by address, interrupts, faults, output to the test
// script. They are freestanding and independent of the product, so that only the reference manual
// links them to the model.

#include <cstdint>

namespace probe {

using Word = std::uint32_t;

inline volatile Word& at(Word address) { return *reinterpret_cast<volatile Word*>(address); }

// Base addresses (RM0090, table 1).
constexpr Word kTim1 = 0x4001'0000, kTim2 = 0x4000'0000, kTim3 = 0x4000'0400;
constexpr Word kTim5 = 0x4000'0C00, kRcc = 0x4002'3800, kPwr = 0x4000'7000;
constexpr Word kFlash = 0x4002'3C00, kGpioA = 0x4002'0000, kGpioB = 0x4002'0400;
constexpr Word kUsart1 = 0x4001'1000, kCan1 = 0x4000'6400, kWatchdog = 0x4000'3000;

// Offsets of the timers' registers.
constexpr Word kCr1 = 0x00, kDier = 0x0C, kSr = 0x10, kEgr = 0x14, kCcmr1 = 0x18, kCcer = 0x20;
constexpr Word kCnt = 0x24, kPsc = 0x28, kArr = 0x2C, kCcr1 = 0x34, kBdtr = 0x44;

using Routine = void (*)();

/// Enables interrupt `number` (RM0090, table 61) and makes it call `handler`.
void on_interrupt(unsigned number, Routine handler);

/// Read or write an address; return whether a bus fault occurred.
bool read_faults(Word address);
bool write_faults(Word address, Word value);

/// Print a line `name value value…`.
void say(const char* name);
void say(const char* name, Word value);
void say(const char* name, Word first, Word second);
[[noreturn]] void end(bool good);

/// Sets up crystal, PLL and five wait states: 168 MHz, APB1 at 42 MHz, APB2 at 84 MHz. Each wait is
/// bounded; returns false if one of them failed.
bool run_at_168_mhz();
/// Enables the clocks of GPIOA to C, TIM1, 2, 3, 5, USART1 and CAN1.
void enable_clocks();

/// Waits until the register's masked bits are `wanted`; returns false after `tries`.
bool wait_for(Word address, Word mask, Word wanted, Word tries = 400'000);
/// Waits by TIM5 and its interrupt, which must not be in use. The core sleeps; other interrupts
/// run.
void wait_us(Word microseconds);
/// Starts TIM2 as a clock of microseconds; clock_us() reads it.
void start_clock();
inline Word clock_us() { return at(kTim2 + kCnt); }

// One function per scenario, each in the file of its peripheral.
void try_clocks();
void try_edges();
void try_inputs();
void try_periods();
void try_one_pulse();
void try_compare();
void try_late_reload();
void try_pwm();
void try_flash();
void try_flash_keys();
void try_flash_cut();
void try_watchdog();
void try_memory();
void try_flip();
void try_usart();
void try_usart_late();
void try_lines();
void try_can_loop();
void try_can_bus();
void try_can_off();
void try_cycles();

}  // namespace probe
