#pragma once

#include <cstdint>
#include <string_view>

#include "tests/target/line_text.hpp"

/// Writes a row of pixels of 0.1 mm, each as a line with its S; or fine pixels of 0.01 mm, many in
/// a line as in an engraved picture, 20,000 in a second.
class RasterText {
 public:
  static constexpr int kLines = 3000;
  static constexpr int kFinePixels = 24'000;

  explicit RasterText(bool is_fine = false)
      : is_fine_{is_fine}, pixels_{is_fine ? kFinePixels : kLines} {}

  [[nodiscard]] bool finished() const { return pixel_ == pixels_; }

  /// Returns the next line, with its LF.
  std::string_view next() {
    constexpr std::int32_t kPixelThousandths = 100;
    constexpr std::int32_t kFineThousandths = 10;
    line_text_.clear();
    if (pixel_ == 0) line_text_.put("G21G90M4F12000");
    line_text_.put("G1");
    if (is_fine_) {
      line_text_.put_number('X', kFineThousandths * (pixel_ + kTogether));
      for (int i = 0; i < kTogether; ++i) put_power(i == 0 ? 'S' : ':');
    } else {
      line_text_.put_number('X', kPixelThousandths * (pixel_ + 1));
      line_text_.put_number('S', 1000 * ((37 * pixel_ + 1) % 1000));
      ++pixel_;
    }
    line_text_.put("\n");
    return line_text_.text();
  }

 private:
  static constexpr int kTogether = 32;

  /// Writes a power with one decimal.
  void put_power(char before) {
    line_text_.put_tenths(before, (371 * pixel_ + 11) % 10'000);
    ++pixel_;
  }

  LineText line_text_{};
  bool is_fine_;
  int pixels_;
  int pixel_ = 0;
};
