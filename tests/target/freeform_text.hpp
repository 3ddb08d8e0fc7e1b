#pragma once

#include <cstdint>
#include <string_view>

#include "planner/base/scalar_math.hpp"
#include "tests/target/line_text.hpp"

/// Writes the job of test::freeform_job line by line, in single precision.
class FreeformText {
 public:
  static constexpr int kLines = 3000;

  /// @param opening words before the words of the first line
  explicit FreeformText(std::string_view opening = "G21G90G1F12000") : opening_{opening} {}

  [[nodiscard]] bool finished() const { return line_ == kLines; }

  /// Returns the next line, with its LF.
  std::string_view next() {
    line_text_.clear();
    if (line_ == 0) line_text_.put(opening_);
    const float s = 0.1F * static_cast<float>(line_++);
    const float angle =
        1.5F * cnc::sin_cos(s / 9.0F).sine + 0.8F * cnc::sin_cos(s / 31.0F).sine + s / 40.0F;
    const cnc::SinCos direction = cnc::sin_cos(angle);
    x_ += 0.1F * direction.cosine;
    y_ += 0.1F * direction.sine;
    line_text_.put_number('X', thousandths(x_));
    line_text_.put(" ");
    line_text_.put_number('Y', thousandths(y_));
    line_text_.put("\n");
    return line_text_.text();
  }

 private:
  [[nodiscard]] static std::int32_t thousandths(float mm) {
    return static_cast<std::int32_t>(mm * 1000.0F + (mm < 0.0F ? -0.5F : 0.5F));
  }

  std::string_view opening_;
  LineText line_text_{};
  int line_ = 0;
  float x_ = 100.0F;
  float y_ = 100.0F;
};
