#pragma once

#include <cstdint>
#include <string_view>

#include "tests/target/line_text.hpp"

/// Writes short lines that move several axes together, each with a power, back and forth. First all
/// axes step together, then each at its own rate.
class AxesText {
 public:
  static constexpr int kLines = 1600;

  /// @param axes number of axes, 1…6
  explicit AxesText(int axes) : axes_{axes} {}

  [[nodiscard]] bool finished() const { return line_ == kLines; }

  /// Returns the next line, with its LF.
  std::string_view next() {
    constexpr std::string_view kLetters = "XYZABC";
    constexpr int kWay = kLines / 4;
    constexpr std::int32_t kStepThousandths = 100;
    line_text_.clear();
    if (line_ == 0) line_text_.put("G21G90M4F6000");
    line_text_.put("G1");
    const int there = line_ % (2 * kWay);
    const std::int32_t place = kStepThousandths * (there < kWay ? there + 1 : 2 * kWay - there - 1);
    const bool together = line_ < 2 * kWay;
    for (int axis = 0; axis < axes_; ++axis) {
      const std::int32_t slower = together ? 0 : place * axis / 9;
      line_text_.put_number(kLetters[static_cast<std::size_t>(axis)], place - slower);
    }
    line_text_.put_number('S', 1000 * ((37 * line_ + 1) % 1000));
    line_text_.put("\n");
    ++line_;
    return line_text_.text();
  }

 private:
  int axes_;
  LineText line_text_{};
  int line_ = 0;
};
