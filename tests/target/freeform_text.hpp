#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "planner/base/scalar_math.hpp"

/// Writes the job, line by line: test::freeform_job in single precision.
class FreeformText {
 public:
  static constexpr int kLines = 3000;

  [[nodiscard]] bool finished() const { return line_ == kLines; }

  /// With its LF.
  std::string_view next() {
    size_ = 0;
    if (line_ == 0) put("G21G90G1F12000");
    const float s = 0.1F * static_cast<float>(line_++);
    const float angle =
        1.5F * cnc::sin_cos(s / 9.0F).sine + 0.8F * cnc::sin_cos(s / 31.0F).sine + s / 40.0F;
    const cnc::SinCos direction = cnc::sin_cos(angle);
    x_ += 0.1F * direction.cosine;
    y_ += 0.1F * direction.sine;
    put_number('X', x_);
    put(" ");
    put_number('Y', y_);
    put("\n");
    return {text_.data(), size_};
  }

 private:
  void put(std::string_view text) {
    for (const char c : text) text_[size_++] = c;
  }

  void put_number(char letter, float mm) {
    text_[size_++] = letter;
    if (mm < 0.0F) text_[size_++] = '-';
    auto rest = static_cast<std::uint32_t>((mm < 0.0F ? -mm : mm) * 1000.0F + 0.5F);
    std::array<char, 11> digits{};
    std::size_t count = 0;
    for (; count < 5 || rest > 0; rest /= 10) {
      digits[count++] = static_cast<char>('0' + rest % 10);
      if (count == 3) digits[count++] = '.';
    }
    while (count > 0) text_[size_++] = digits[--count];
  }

  std::array<char, 64> text_{};
  std::size_t size_ = 0;
  int line_ = 0;
  float x_ = 100.0F;
  float y_ = 100.0F;
};
