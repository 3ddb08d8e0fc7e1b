#pragma once

#include <array>
#include <cstddef>
#include <string_view>

namespace cnc {

/// Collects bytes into lines. A line ends with CR, LF or CR LF, and the pair
/// counts once, so that every line gets one answer.
///
/// A line that does not fit keeps its first Capacity bytes; `too_long` then
/// says so, and the rest up to the line end is dropped.
template <std::size_t Capacity>
class LineAssembler {
 public:
  /// True when the byte completes a line; read it before the next byte.
  bool add(char byte) {
    if (complete_) start_anew();
    if (byte == '\n' && after_return_) {
      after_return_ = false;
      return false;
    }
    after_return_ = byte == '\r';
    if (byte == '\r' || byte == '\n') {
      complete_ = true;
      return true;
    }
    if (size_ == Capacity) {
      too_long_ = true;
    } else {
      bytes_[size_++] = byte;
    }
    return false;
  }

  /// Without its line end. @pre add() returned true last
  [[nodiscard]] std::string_view line() const { return {bytes_.data(), size_}; }
  [[nodiscard]] bool too_long() const { return too_long_; }

 private:
  void start_anew() {
    size_ = 0;
    too_long_ = false;
    complete_ = false;
  }

  std::array<char, Capacity> bytes_{};
  std::size_t size_ = 0;
  bool too_long_ = false;
  bool complete_ = false;
  bool after_return_ = false;
};

}  // namespace cnc
