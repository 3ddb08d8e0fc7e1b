#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "planner/base/contract.hpp"

namespace cnc::gcode {

/// Buffer for the text of the lines of one motion.
class LineText {
 public:
  /// Capacity for four lines of `G1X-500000.000Y…I…J…F…S…`, the longest text that a writer makes.
  static constexpr std::size_t kCapacity = 512;

  void clear() { size_ = 0; }
  void add(char character) {
    CNC_ASSERT(size_ < kCapacity);
    text_[size_++] = character;
  }
  /// Adds a letter and a number with at most `decimals` decimals. Zeros at the end of the decimals
  /// are omitted.
  /// @param value the number in units of its last decimal
  /// @pre decimals ≤ 9
  void add_word(char letter, std::int64_t value, std::uint8_t decimals);

  [[nodiscard]] std::string_view view() const { return {text_.data(), size_}; }

 private:
  std::array<char, kCapacity> text_{};
  std::size_t size_ = 0;
};

}  // namespace cnc::gcode
