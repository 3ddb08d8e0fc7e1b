#pragma once

/// Start-up of an STM32F405 before the program: initializes memory, and checks whether the image
/// may run on this chip.

#include <array>
#include <cstddef>
#include <span>

#include "hal/stm32f405/clock.hpp"
#include "hal/stm32f405/fitness.hpp"

namespace target {

/// Sets memory up as C++ wants it, and paints the stack below the caller.
void begin_memory();

/// Returns the image but for the four bytes of its checksum.
std::array<std::span<const std::byte>, 2> checked_parts();

/// Checks that the flash holds what was built. Needs no memory that is set up.
bool image_is_whole();

/// Tells on every link why nothing runs, until a reset or the way into the boot loader.
[[noreturn]] void refuse(const hal::stm32f405::Clocks& clocks,
                         const hal::stm32f405::Fitness& fitness);

}  // namespace target
