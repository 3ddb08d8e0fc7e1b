#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

/// Builds a line of G-code with whole numbers only, so that the text is the same on every machine.
class LineText {
 public:
  void clear() { size_ = 0; }
  [[nodiscard]] std::string_view text() const { return {text_.data(), size_}; }

  void put(std::string_view text) {
    for (const char c : text) text_[size_++] = c;
  }

  /// Writes a number of 0 or more with one decimal.
  void put_tenths(char before, std::int32_t tenths) {
    text_[size_++] = before;
    for (std::int32_t digit = 1000; digit > 1; digit /= 10) {
      if (tenths >= digit || digit == 10) {
        text_[size_++] = static_cast<char>('0' + tenths / digit % 10);
      }
    }
    text_[size_++] = '.';
    text_[size_++] = static_cast<char>('0' + tenths % 10);
  }

  void put_number(char letter, std::int32_t thousandths) {
    text_[size_++] = letter;
    if (thousandths < 0) text_[size_++] = '-';
    auto rest = static_cast<std::uint32_t>(thousandths < 0 ? -thousandths : thousandths);
    std::array<char, 12> digits{};
    std::size_t count = 0;
    for (; count < 5 || rest > 0; rest /= 10) {
      digits[count++] = static_cast<char>('0' + rest % 10);
      if (count == 3) digits[count++] = '.';
    }
    while (count > 0) text_[size_++] = digits[--count];
  }

 private:
  std::array<char, 256> text_{};
  std::size_t size_ = 0;
};
