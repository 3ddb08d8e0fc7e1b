#pragma once

#include <charconv>
#include <cmath>
#include <cstddef>
#include <optional>
#include <string_view>

namespace sim::drawing {

/// Reads the numbers and words of SVG attributes. They are separated by blanks or commas, or follow
/// each other directly, as in `1-2`.
class Scanner {
 public:
  explicit Scanner(std::string_view text) : text_{text} {}

  [[nodiscard]] bool at_end() {
    skip_blanks();
    return at_ == text_.size();
  }
  /// Returns the column of the next character, from 1.
  [[nodiscard]] std::size_t column() const { return at_ + 1; }
  [[nodiscard]] std::string_view rest() const { return text_.substr(at_); }

  /// Skips blanks and returns the next character without consuming it; 0 at the end.
  [[nodiscard]] char peek() {
    skip_blanks();
    return at_ < text_.size() ? text_[at_] : '\0';
  }
  void skip() { ++at_; }
  bool take(char wanted) {
    if (peek() != wanted) return false;
    ++at_;
    return true;
  }
  /// Consumes a comma if the next character is one.
  void separate() { static_cast<void>(take(',')); }

  /// Consumes a finite number and returns it. If the next text is no number, returns nothing and
  /// consumes only blanks.
  std::optional<double> number() {
    skip_blanks();
    std::size_t from = at_;
    if (from < text_.size() && text_[from] == '+') ++from;
    const std::size_t digits = from + (from < text_.size() && text_[from] == '-' ? 1 : 0);
    if (digits >= text_.size() || !starts_number(text_[digits])) return {};
    double value = 0.0;
    const char* const end = text_.data() + text_.size();
    const auto [stop, error] = std::from_chars(text_.data() + from, end, value);
    if (error != std::errc{} || !std::isfinite(value)) return {};
    at_ = static_cast<std::size_t>(stop - text_.data());
    return value;
  }

  /// Consumes a flag, 0 or 1, and returns it. Other text may follow it without a separator.
  std::optional<bool> flag() {
    const char next = peek();
    if (next != '0' && next != '1') return {};
    ++at_;
    return next == '1';
  }

  /// Consumes a word of letters and hyphens and returns it; empty if the next text is no word.
  std::string_view word() {
    skip_blanks();
    const std::size_t from = at_;
    while (at_ < text_.size() && is_letter(text_[at_])) ++at_;
    return text_.substr(from, at_ - from);
  }

 private:
  static bool starts_number(char c) { return (c >= '0' && c <= '9') || c == '.'; }
  static bool is_letter(char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '-';
  }
  void skip_blanks() {
    while (at_ < text_.size() &&
           std::string_view{" \t\r\n\f"}.find(text_[at_]) != std::string_view::npos) {
      ++at_;
    }
  }

  std::string_view text_;
  std::size_t at_ = 0;
};

}  // namespace sim::drawing
