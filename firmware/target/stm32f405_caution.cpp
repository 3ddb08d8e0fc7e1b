/// A question that the user must answer before flashing the image onto the board. The text is only
/// in the ELF file, never on the chip; toolchain/image_files.py prints it.

#include <array>
#include <cstddef>
#include <string_view>

#include KERFLINE_BOARD_HEADER
#include "hal/stm32f405/board_sheet.hpp"

namespace target {
namespace {

constexpr std::string_view kText = hal::stm32f405::kSheet<hal::stm32f405::KERFLINE_BOARD>.caution;

[[gnu::section(".caution"), gnu::used]] constexpr auto kCaution = [] {
  std::array<char, kText.size() + 1> text{};
  for (std::size_t i = 0; i < kText.size(); ++i) text[i] = kText[i];
  return text;
}();

}  // namespace
}  // namespace target
