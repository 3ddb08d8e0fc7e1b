#include "planner/gcode/line_text.hpp"

namespace cnc::gcode {

void LineText::add_word(char letter, std::int64_t value, std::uint8_t decimals) {
  add(letter);
  if (value < 0) add('-');
  auto rest = static_cast<std::uint64_t>(value < 0 ? -value : value);
  while (decimals > 0 && rest % 10 == 0) {
    rest /= 10;
    --decimals;
  }
  constexpr std::size_t kMaxDigits = 20;
  std::array<char, kMaxDigits> digits{};
  std::size_t count = 0;
  do {
    digits[count++] = static_cast<char>('0' + rest % 10);
    rest /= 10;
  } while (rest != 0 || count <= decimals);
  while (count > 0) {
    add(digits[--count]);
    if (count == decimals && count > 0) add('.');
  }
}

}  // namespace cnc::gcode
