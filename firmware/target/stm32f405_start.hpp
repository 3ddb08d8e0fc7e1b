#pragma once

/// Start-up of an STM32F405 before the program: initializes memory, and checks whether the image
/// may run on this chip.

#include <array>
#include <cstddef>
#include <span>

#include "hal/stm32f405/clock.hpp"
#include "hal/stm32f405/fitness.hpp"

namespace target {

/// Sets up memory as C++ requires, and fills the stack below the caller with kPaint.
void begin_memory();

/// Returns the image without the four bytes of its checksum.
std::array<std::span<const std::byte>, 2> checked_parts();

/// Checks that the flash holds the image as it was built. Needs no memory to be set up.
bool image_is_whole();

/// Reports on every link why nothing runs, until a reset or the way into the boot loader.
[[noreturn]] void refuse(const hal::stm32f405::Clocks& clocks,
                         const hal::stm32f405::Fitness& fitness);

}  // namespace target
