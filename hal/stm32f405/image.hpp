#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

/// Addresses that the linker script defines (toolchain/stm32f405.ld).
extern "C" {
extern std::byte image_begin[], image_end[];
extern std::uint32_t stack_guard[], stack_bottom[], stack_top[];
extern std::uint32_t data_begin[], data_end[], bss_begin[], bss_end[];
extern std::uint32_t ccm_begin[], ccm_end[];
extern std::uint32_t data_load[];
using Routine = void (*)();
extern Routine init_begin[], init_end[];
}

namespace hal::stm32f405 {

/// Header after the interrupt vectors, with which start-up detects a truncated or damaged image.
/// The linker script places it, and toolchain/image_files.py computes the checksum.
struct ImageHeader {
  static constexpr std::uint32_t kMagic = 0x4E'46'52'4B;  ///< "KRFN"

  std::uint32_t magic;
  std::uint32_t bytes;     ///< Length of the image in bytes, from its vectors to its end.
  std::uint32_t checksum;  ///< CRC-32 of the image without the four bytes of this field.
};
}  // namespace hal::stm32f405

extern "C" const hal::stm32f405::ImageHeader image_header;  // NOLINT(readability-identifier-naming)

namespace hal::stm32f405 {

/// Value with which start-up fills the unused stack.
inline constexpr std::uint32_t kPaint = 0xC0DE'5AFE;

/// Returns the number of words at the low end of a stack that were never used.
constexpr std::size_t unused_words(std::span<const std::uint32_t> stack) {
  std::size_t unused = 0;
  while (unused < stack.size() && stack[unused] == kPaint) ++unused;
  return unused;
}

}  // namespace hal::stm32f405
