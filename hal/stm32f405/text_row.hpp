#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

namespace hal::stm32f405 {

/// Writes a line into memory of the caller. Text that does not fit is cut off.
class TextRow {
 public:
  explicit TextRow(std::span<char> into) : into_{into} {}

  TextRow& text(const char* words) {
    while (*words != '\0') letter(*words++);
    return *this;
  }
  TextRow& number(std::uint32_t value) {
    std::uint32_t unit = 1;
    while (value / unit >= 10) unit *= 10;
    for (; unit > 0; unit /= 10) letter(static_cast<char>('0' + value / unit % 10));
    return *this;
  }
  /// Appends the value as eight hexadecimal digits.
  TextRow& hexadecimal(std::uint32_t value) {
    for (unsigned digit = 8; digit-- > 0;) letter("0123456789abcdef"[value >> (4 * digit) & 0xFU]);
    return *this;
  }
  [[nodiscard]] std::size_t size() const { return size_; }

 private:
  void letter(char one) {
    if (size_ < into_.size()) into_[size_++] = one;
  }

  std::span<char> into_;
  std::size_t size_ = 0;
};

}  // namespace hal::stm32f405
