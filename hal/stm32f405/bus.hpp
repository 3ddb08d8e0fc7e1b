#pragma once

#include <concepts>
#include <cstdint>

#include "hal/stm32f405/registers.hpp"

namespace hal::stm32f405 {

/// Access of the port to its registers: by loads and stores on the chip, by a model of the
/// registers in a test. Any context.
template <typename Type>
concept RegisterBus = requires(Address address, Word value) {
  { Type::read(address) }
  noexcept->std::same_as<Word>;
  { Type::write(address, value) }
  noexcept->std::same_as<void>;
  { Type::barrier() }
  noexcept->std::same_as<void>;
};

/// Access to the real registers of the chip.
struct MemoryBus {
  static Word read(Address address) noexcept { return *at(address); }
  static void write(Address address, Word value) noexcept { *at(address) = value; }
  /// Completes all earlier accesses before the next instruction is fetched.
  static void barrier() noexcept { asm volatile("dsb \n isb" ::: "memory"); }

 private:
  static volatile Word* at(Address address) noexcept {
    // The manual gives each address as a number. NOLINTNEXTLINE(performance-no-int-to-ptr)
    return reinterpret_cast<volatile Word*>(static_cast<std::uintptr_t>(address));
  }
};
static_assert(RegisterBus<MemoryBus>);

/// Replaces the bits in `mask` by the bits of `value`. The change is not atomic.
template <RegisterBus Bus>
void modify(Address address, Word mask, Word value) noexcept {
  Bus::write(address, (Bus::read(address) & ~mask) | value);
}

template <RegisterBus Bus>
void set(Address address, Word bits) noexcept {
  modify<Bus>(address, 0, bits);
}

template <RegisterBus Bus>
void clear(Address address, Word bits) noexcept {
  modify<Bus>(address, bits, 0);
}

/// Reads the register until the bits in `mask` equal `wanted`, at most `looks` times. Returns false
/// if they never became equal.
template <RegisterBus Bus>
[[nodiscard]] bool wait_for(Address address, Word mask, Word wanted, std::uint32_t looks) noexcept {
  for (std::uint32_t look = 0; look < looks; ++look) {
    if ((Bus::read(address) & mask) == wanted) return true;
  }
  return false;
}

/// Enables an interrupt.
/// @param priority 0 (most urgent) to 15
template <RegisterBus Bus>
void enable_interrupt(unsigned number, unsigned priority) noexcept {
  const unsigned place = 8 * (number % 4) + 4;  // The priority is in the upper half of its byte.
  modify<Bus>(core::interrupt_priority(number), Word{0xF} << place, Word{priority} << place);
  Bus::write(core::interrupt_on(number), bit(number % 32));
}

/// Makes an interrupt pending, so that it runs as soon as its priority allows.
template <RegisterBus Bus>
void pend_interrupt(unsigned number) noexcept {
  Bus::write(core::interrupt_pend(number), bit(number % 32));
}

}  // namespace hal::stm32f405
