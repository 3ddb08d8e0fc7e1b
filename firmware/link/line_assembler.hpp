#pragma once

#include <array>
#include <cstddef>
#include <string_view>

#include "firmware/link/line_mark.hpp"

namespace cnc {

/// Collects bytes into lines. A line ends with CR, LF or CR LF. CR LF counts as one line end, so
/// that every line gets one answer.
///
/// If a line does not fit, the text of its comments is dropped, so that comments of any length are
/// allowed. If the line still does not fit, its first Capacity bytes are kept and the rest up to
/// the line end is dropped. `too_long` then returns true.
template <std::size_t Capacity>
class LineAssembler {
 public:
  /// Adds a byte. Returns true if the byte completes a line; line() is then valid until the next
  /// byte is added.
  bool add(char byte) {
    if (size_ >= plain_to_ || byte == '\r' || byte == '\n') return add_other(byte);
    bytes_[size_++] = byte;
    return false;
  }

  /// Returns the line without its line end.
  /// @pre the last add() returned true
  [[nodiscard]] std::string_view line() const { return {bytes_.data(), size_}; }
  [[nodiscard]] bool too_long() const { return too_long_; }
  /// Returns whether the line contains all bytes that were added to it.
  [[nodiscard]] bool whole() const { return !too_long_ && !shortened_; }
  /// Returns the check of a line from which bytes were dropped; null if whole().
  [[nodiscard]] const LongLineCheck* long_line() const { return whole() ? nullptr : &check_; }
  /// Returns whether the complete line ended with CR. If the next byte is LF, it belongs to the
  /// same line end.
  [[nodiscard]] bool ends_with_return() const { return ended_by_ == '\r'; }
  /// Returns whether a line has begun but not ended.
  [[nodiscard]] bool has_begun() const { return ended_by_ == kNothing && size_ > 0; }

 private:
  static constexpr char kNothing = 0;

  /// Adds a byte that ends a line, follows a line end, or belongs to a line that does not fit.
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

  /// Drops the text of comments, but keeps their brackets, including nested opening brackets, and
  /// the semicolon.
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
  /// While size_ is smaller than this, add() only appends a byte that does not end the line. It is
  /// 0 after a line end and in a line that does not fit.
  std::size_t plain_to_ = Capacity;
  bool shortened_ = false;  ///< Text of comments was dropped from this line.
  bool too_long_ = false;
  bool long_ = false;  ///< The line has more bytes than fit.
  LongLineCheck check_{};
  /// Byte that ended the complete line; kNothing while the line is open.
  char ended_by_ = kNothing;
};

}  // namespace cnc
