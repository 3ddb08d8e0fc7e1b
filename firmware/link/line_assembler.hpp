#pragma once

#include <array>
#include <cstddef>
#include <string_view>

#include "firmware/link/line_mark.hpp"

namespace cnc {

/// Collects bytes into lines. A line ends with CR, LF or CR LF, and the pair
/// counts once, so that every line gets one answer.
///
/// Of a line that does not fit, the text of its comments is dropped, however long they are. If that
/// is not enough it keeps its first Capacity bytes; `too_long` then says so, and the rest up to
/// the line end is dropped.
template <std::size_t Capacity>
class LineAssembler {
 public:
  /// True when the byte completes a line; read it before the next byte.
  bool add(char byte) {
    if (size_ >= plain_to_ || byte == '\r' || byte == '\n') return add_other(byte);
    bytes_[size_++] = byte;
    return false;
  }

  /// Without its line end. @pre add() returned true last
  [[nodiscard]] std::string_view line() const { return {bytes_.data(), size_}; }
  [[nodiscard]] bool too_long() const { return too_long_; }
  /// All bytes that came are there.
  [[nodiscard]] bool whole() const { return !too_long_ && !shortened_; }
  /// Returns the check of a line that is not whole(), else null.
  [[nodiscard]] const LongLineCheck* long_line() const { return whole() ? nullptr : &check_; }
  /// The line that is there ended with CR: an LF next belongs to it.
  [[nodiscard]] bool ends_with_return() const { return ended_by_ == '\r'; }
  /// In the middle of a line.
  [[nodiscard]] bool has_begun() const { return ended_by_ == kNothing && size_ > 0; }

 private:
  static constexpr char kNothing = 0;

  /// Takes a byte that ends a line, comes after one, or is of a long one.
  [[gnu::noinline]] bool add_other(char byte) {
    if (ended_by_ != kNothing) {
      const bool pair = ended_by_ == '\r' && byte == '\n';
      start_anew();
      if (pair) return false;
    }
    if (byte == '\r' || byte == '\n') {
      if (shortened_) drop_comments();
      ended_by_ = byte;
      plain_to_ = 0;
      return true;
    }
    if (size_ == Capacity && !long_) begin_long();
    if (long_) check_.add(byte);
    if (size_ == Capacity) drop_comments();
    if (size_ == Capacity) {
      too_long_ = true;
    } else {
      bytes_[size_++] = byte;
    }
    return false;
  }

  void start_anew() {
    size_ = 0;
    plain_to_ = Capacity;
    too_long_ = false;
    ended_by_ = kNothing;
    shortened_ = false;
    long_ = false;
  }

  void begin_long() {
    long_ = true;
    plain_to_ = 0;
    check_ = {};
    for (const char byte : bytes_) check_.add(byte);
  }

  /// Keeps the brackets of comments, nested ones too, and the semicolon.
  void drop_comments() {
    std::size_t kept = 0;
    char comment = kNothing;
    for (std::size_t i = 0; i < size_; ++i) {
      const char byte = bytes_[i];
      if (comment == '(' && byte == ')') comment = kNothing;
      if (comment == ';' || (comment == '(' && byte != '(')) {
        shortened_ = true;
        continue;
      }
      if (byte == '(' || byte == ';') comment = byte;
      bytes_[kept++] = byte;
    }
    size_ = kept;
  }

  std::array<char, Capacity> bytes_{};
  std::size_t size_ = 0;
  std::size_t plain_to_ = Capacity;  ///< Up to here bytes are only kept; 0 behind a line's end.
  bool shortened_ = false;           ///< By text of comments.
  bool too_long_ = false;
  bool long_ = false;  ///< More bytes came than there is space for.
  LongLineCheck check_{};
  char ended_by_ = kNothing;  ///< The line that is there, which the next byte begins anew.
};

}  // namespace cnc
