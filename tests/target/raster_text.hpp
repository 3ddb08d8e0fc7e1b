#pragma once

#include <cstdint>
#include <string_view>

#include "tests/target/line_text.hpp"

/// Writes a row of pixels of 0.1 mm, each a line with its S.
class RasterText {
 public:
  static constexpr int kLines = 3000;

  [[nodiscard]] bool finished() const { return line_ == kLines; }

  /// With its LF.
  std::string_view next() {
    constexpr std::int32_t kPixelThousandths = 100;
    line_text_.clear();
    if (line_ == 0) line_text_.put("G21G90M4F12000");
    line_text_.put("G1");
    line_text_.put_number('X', kPixelThousandths * (line_ + 1));
    line_text_.put_number('S', 1000 * ((37 * line_ + 1) % 1000));
    line_text_.put("\n");
    ++line_;
    return line_text_.text();
  }

 private:
  LineText line_text_{};
  int line_ = 0;
};
