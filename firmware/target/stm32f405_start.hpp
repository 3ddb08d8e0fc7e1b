#pragma once

/// The part of the start-up of an STM32F405 that runs before the program: initializes memory, and
/// checks whether the image may run on this chip.

#include <array>
#include <cstddef>
#include <span>

#include "hal/stm32f405/clock.hpp"
#include "hal/stm32f405/fitness.hpp"

namespace target {

/// Initializes the variables as C++ requires. Fills the stack below the caller's frame with kPaint,
/// by which the used depth of the stack is found later.
void begin_memory();

/// Returns the two parts of the image before and after the four bytes of its checksum.
std::array<std::span<const std::byte>, 2> checked_parts();

/// Returns whether the flash contains the unchanged image. May be called before begin_memory().
bool image_is_whole();

/// Reports on every link why the image does not run, until a reset or the change to the boot
/// loader.
[[noreturn]] void refuse(const hal::stm32f405::Clocks& clocks,
                         const hal::stm32f405::Fitness& fitness);

}  // namespace target
