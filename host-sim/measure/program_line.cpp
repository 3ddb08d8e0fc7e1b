#include "host-sim/measure/program_line.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>

#include "planner/base/axes.hpp"

namespace sim {
namespace {

bool is_letter(char c) { return c >= 'A' && c <= 'Z'; }
bool is_white(char c) { return static_cast<unsigned char>(c) <= ' '; }
bool is_digit(char c) { return c >= '0' && c <= '9'; }
char to_upper(char c) { return c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c; }

/// Returns a line in upper case, without comments and white space.
std::string without_comments(std::string_view text) {
  std::string bare;
  bool in_comment = false;
  for (const char c : text) {
    if (c == ';' && !in_comment) break;
    if (c == '(') in_comment = true;
    if (!in_comment && !is_white(c)) bare.push_back(to_upper(c));
    if (c == ')') in_comment = false;
  }
  return bare;
}

/// Reads a number at the beginning of `text` and removes it from `text`.
std::optional<double> take_number(std::string_view& text) {
  std::string_view digits = text;
  if (!digits.empty() && digits.front() == '+') digits.remove_prefix(1);
  const std::size_t sign = !digits.empty() && digits.front() == '-' ? 1 : 0;
  // The check is necessary because from_chars() also reads "inf" and "nan".
  if (digits.size() <= sign || is_letter(digits[sign])) return std::nullopt;
  double value = 0.0;
  // The controller accepts at most nine digits before the decimal point.
  constexpr double kTooLarge = 1.0e9;
  const auto [end, error] = std::from_chars(
      digits.data(), digits.data() + digits.size(), value, std::chars_format::fixed);
  if (error != std::errc{} || std::abs(value) >= kTooLarge) return std::nullopt;
  text.remove_prefix(static_cast<std::size_t>(end - text.data()));
  return value;
}

void add_word(ProgramLine& line, char letter, double value) {
  if (letter == 'G') {
    line.g.push_back(static_cast<int>(std::lround(value * 10.0)));
  } else if (letter == 'M') {
    line.m.push_back(static_cast<int>(std::lround(value)));
  } else {
    std::optional<double>& place = line.values[static_cast<std::size_t>(letter - 'A')];
    if (place) line.faults.push_back(std::string{"a second "} + letter);
    place = value;
  }
}

/// Returns whether the rest of the line is ignored, because it follows a slash or is the name of a
/// program. Removes a slash that has no effect.
bool skips(std::string_view& rest, bool block_delete) {
  if (rest.starts_with('/')) {
    if (block_delete) return true;
    rest.remove_prefix(1);
    if (!rest.empty() && is_digit(rest.front())) rest.remove_prefix(1);
  }
  return rest.starts_with('%') || rest.starts_with(':') || rest.starts_with('O');
}

}  // namespace

std::optional<double> ProgramLine::value(char letter) const {
  return values[static_cast<std::size_t>(letter - 'A')];
}

bool ProgramLine::has_g(int tenths) const { return std::ranges::find(g, tenths) != g.end(); }

bool ProgramLine::has_axis_words() const {
  return std::ranges::any_of(cnc::kAxisLetters,
                             [this](char letter) { return value(letter).has_value(); });
}

ProgramLine take_apart(std::string_view text, bool block_delete) {
  ProgramLine line;
  const std::string bare = without_comments(text);
  std::string_view rest = bare;
  if (skips(rest, block_delete)) return line;
  for (bool first = true; !rest.empty(); first = false) {
    const char letter = rest.front();
    rest.remove_prefix(1);
    const std::optional<double> number = is_letter(letter) ? take_number(rest) : std::nullopt;
    if (!number) {
      line.faults.push_back(std::string{"not a word: "} + letter + std::string{rest});
      break;
    }
    add_word(line, letter, *number);
    if (first && letter == 'N' && skips(rest, block_delete)) break;
    while (letter == 'S' && rest.starts_with(':')) {
      rest.remove_prefix(1);
      const std::optional<double> power = take_number(rest);
      if (!power) break;
      if (line.powers.empty()) line.powers.push_back(*number);
      line.powers.push_back(*power);
    }
  }
  return line;
}

bool block_delete_after(std::string_view line, bool before) {
  constexpr std::string_view kSetting = "$890=";
  const std::size_t front = line.find_first_not_of(" \t");
  if (front == std::string_view::npos || line[front] != '$') return before;
  const std::string bare = without_comments(line);
  if (bare == "$B") return !before;
  if (!bare.starts_with(kSetting)) return before;
  double value = 0.0;
  const char* const end = bare.data() + bare.size();
  const auto read = std::from_chars(bare.data() + kSetting.size(), end, value);
  return read.ec == std::errc{} && read.ptr == end ? value != 0.0 : before;
}

std::string_view take_line(std::string_view& text) {
  const std::size_t end = std::min(text.find_first_of("\r\n"), text.size());
  const std::string_view line = text.substr(0, end);
  const bool pair = text.substr(end, 2) == "\r\n";
  text.remove_prefix(std::min(end + (pair ? 2 : 1), text.size()));
  return line;
}

}  // namespace sim
