#include "host-sim/order/file_words.hpp"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <system_error>

namespace sim::order {
namespace {

constexpr std::string_view kBlanks = " \t\r\n";
constexpr std::string_view kEndOfWord = " \t\r\n:";

std::string_view word_of(std::string_view text) {
  if (text.starts_with(':')) return text.substr(0, 1);
  return text.substr(0, text.find_first_of(kEndOfWord));
}

template <typename Number>
bool read(std::string_view word, Number& value) {
  if (word.starts_with('+')) word.remove_prefix(1);
  const auto [end, fault] = std::from_chars(word.data(), word.data() + word.size(), value);
  return fault == std::errc{} && end == word.data() + word.size();
}

}  // namespace

void FileWords::skip_blanks() {
  while (!rest_.empty() && kBlanks.find(rest_.front()) != std::string_view::npos) {
    if (rest_.front() == '\n') ++line_;
    rest_.remove_prefix(1);
  }
}

std::string_view FileWords::next() {
  skip_blanks();
  const std::string_view word = word_of(rest_);
  rest_.remove_prefix(word.size());
  return word;
}

std::string_view FileWords::peek() const {
  const std::size_t begin = rest_.find_first_not_of(kBlanks);
  return begin == std::string_view::npos ? std::string_view{} : word_of(rest_.substr(begin));
}

std::string_view FileWords::rest_of_line() {
  std::string_view line = rest_.substr(0, rest_.find('\n'));
  rest_.remove_prefix(line.size());
  line.remove_prefix(std::min(line.find_first_not_of(kBlanks), line.size()));
  return line.substr(0, line.find_last_not_of(kBlanks) + 1);
}

double FileWords::number(std::string_view what) {
  const std::string_view word = next();
  if (word.empty()) fail(fmt::format("the file ends where {} is required; complete it", what));
  double value = 0.0;
  if (!read(word, value) || !std::isfinite(value)) {
    fail(fmt::format("`{}` is not a number; write {}", word, what));
  }
  return value;
}

std::int64_t FileWords::whole_number(std::string_view what, std::int64_t least, std::int64_t most) {
  const std::string_view word = next();
  if (word.empty()) fail(fmt::format("the file ends where {} is required; complete it", what));
  std::int64_t value = 0;
  if (!read(word, value)) fail(fmt::format("`{}` is not a whole number; write {}", word, what));
  if (value < least || value > most) {
    fail(fmt::format("{} is out of range; write {}, {} to {}", value, what, least, most));
  }
  return value;
}

void FileWords::fail(std::string_view reason) const { fail_at(line_, reason); }

void FileWords::fail_at(std::size_t line, std::string_view reason) const {
  throw OrderFileError{file_, line, reason};
}

}  // namespace sim::order
