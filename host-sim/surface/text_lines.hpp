#pragma once

#include <algorithm>
#include <cstddef>
#include <optional>
#include <string_view>

namespace sim::surface {

[[nodiscard]] inline bool is_blank(char c) {
  return c == ' ' || c == '\t' || c == '\r' || c == '\f' || c == '\v';
}

/// Returns `text` without blanks at its ends.
[[nodiscard]] inline std::string_view without_blanks_around(std::string_view text) {
  while (!text.empty() && is_blank(text.front())) text.remove_prefix(1);
  while (!text.empty() && is_blank(text.back())) text.remove_suffix(1);
  return text;
}

/// Returns whether `text`, converted to lower case ASCII, equals `small`.
[[nodiscard]] inline bool equals_in_small_letters(std::string_view text, std::string_view small) {
  return std::equal(text.begin(), text.end(), small.begin(), small.end(), [](char a, char b) {
    return (a >= 'A' && a <= 'Z' ? static_cast<char>(a - 'A' + 'a') : a) == b;
  });
}

/// Divides a text into lines. A line ends in LF or CR LF, or in CR alone if the text has no LF.
class TextLines {
 public:
  explicit TextLines(std::string_view text)
      : rest_{text}, end_{text.find('\n') == std::string_view::npos ? '\r' : '\n'} {}

  /// Returns the next line without blanks at its ends; nothing at the end of the text.
  std::optional<std::string_view> next() {
    if (rest_.empty()) return {};
    const std::size_t end = rest_.find(end_);
    const std::string_view line = rest_.substr(0, end);
    rest_.remove_prefix(end == std::string_view::npos ? rest_.size() : end + 1);
    ++number_;
    return without_blanks_around(line);
  }
  /// Returns the number of the line that next() returned last, counted from 1.
  [[nodiscard]] std::size_t number() const { return number_; }
  /// Returns the bytes after the line that next() returned last.
  [[nodiscard]] std::string_view rest() const { return rest_; }

 private:
  std::string_view rest_;
  char end_;
  std::size_t number_ = 0;
};

/// Divides a text into words, which are separated by blanks and ends of lines.
class TextWords {
 public:
  TextWords(std::string_view text, std::size_t first_line) : rest_{text}, line_{first_line} {}

  /// Returns the next word; an empty word at the end of the text.
  std::string_view next() {
    std::size_t from = 0;
    while (from < rest_.size() && (is_blank(rest_[from]) || rest_[from] == '\n')) {
      if (rest_[from] == '\n') ++line_;
      ++from;
    }
    std::size_t to = from;
    while (to < rest_.size() && !is_blank(rest_[to]) && rest_[to] != '\n') ++to;
    const std::string_view word = rest_.substr(from, to - from);
    rest_.remove_prefix(to);
    return word;
  }
  /// Skips the rest of the line, for example a comment.
  void skip_line() { rest_.remove_prefix(std::min(rest_.find('\n'), rest_.size())); }
  /// Returns the line of the word that next() returned last.
  [[nodiscard]] std::size_t line() const { return line_; }
  [[nodiscard]] std::string_view rest() const { return rest_; }

 private:
  std::string_view rest_;
  std::size_t line_;
};

}  // namespace sim::surface
