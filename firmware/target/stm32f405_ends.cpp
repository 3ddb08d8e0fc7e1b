#include "firmware/target/stm32f405_ends.hpp"

#include <cstddef>

#include "firmware/target/stm32f405_controller.hpp"
#include "hal/stm32f405/image.hpp"
#include "planner/base/contract.hpp"

namespace chip = hal::stm32f405;

namespace target {

using Bus = chip::MemoryBus;
using Power = chip::PowerPin<kBoard, Bus>;

[[gnu::section(".noinit")]] Kept kept;

void restart() {
  asm volatile("dsb" ::: "memory");
  Bus::write(chip::core::kResetControl, chip::core::kResetNow);
  for (;;) {
  }
}

void stop(chip::Fault fault, std::uint32_t exception, std::uint32_t place) {
  Power::darken();
  kept.fault = {.mark = chip::FaultRecord::kValid,
                .fault = fault,
                .exception = static_cast<std::uint8_t>(exception),
                .place = place};
  restart();
}

void enter_boot_loader() {
  kept.wanted = 0;
  chip::set<Bus>(chip::rcc::kApb2Enr, chip::rcc::kSystemClock);
  Bus::write(chip::syscfg::kRemap, chip::syscfg::kSystemMemory);
  asm volatile(
      "msr msp, %0 \n"
      "cpsie i     \n"
      "bx %1       \n"
      :
      : "r"(Bus::read(chip::kSystemMemory)), "r"(Bus::read(chip::kSystemMemory + 4)));
  __builtin_unreachable();
}

void stand_still() {
  // Clears memory word by word instead of by a library function, because a truncated image may lack
  // that function.
  kept.wanted = 0;
  kept.fault.mark = 0;
  for (;;) asm volatile("wfi");
}

}  // namespace target

void cnc::contract_failed(const char*, const char*, int) {
  target::stop(chip::Fault::kContract, 0, target::address_of(__builtin_return_address(0)));
}

using namespace target;

extern "C" {

/// Called if an object calls a pure virtual function while it is under construction; this never
/// happens.
[[noreturn]] void __cxa_pure_virtual() {
  stop(chip::Fault::kContract, 0, address_of(__builtin_return_address(0)));
}

/// Handles a fault of the core.
/// @param frame address of the registers that the core pushed: r0 to r3, r12, lr, pc, status
[[noreturn, gnu::used]] void fault_taken(const std::uint32_t* frame, std::uint32_t exception) {
  Power::darken();
  constexpr std::uint32_t kNmi = 2;
  constexpr std::ptrdiff_t kFrameWords = 8;
  constexpr std::ptrdiff_t kProgramCounter = 6;
  if (frame < stack_bottom) stop(chip::Fault::kStack, exception, 0);
  if (exception == kNmi) stop(chip::Fault::kCrystal, exception, 0);
  const bool readable = frame + kFrameWords <= stack_top;
  stop(chip::Fault::kException, exception, readable ? frame[kProgramCounter] : 0);
}

/// Entry of all faults. Switches to a new stack first, because an overflowed stack cannot be used
/// to handle a fault.
[[gnu::naked, noreturn]] void fault_entry() {
  asm volatile(
      "mrs   r0, msp      \n"
      "mrs   r1, ipsr     \n"
      "ldr   r2, =stack_top \n"
      "mov   sp, r2       \n"
      "b     fault_taken  \n");
}

void supply_interrupt() { stop(chip::Fault::kSupply, 0, 0); }

}  // extern "C"
