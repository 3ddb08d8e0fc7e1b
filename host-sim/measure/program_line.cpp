#include "host-sim/measure/program_line.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>

#include "planner/base/axes.hpp"

namespace sim {
namespace {

bool is_letter(char c) { return c >= 'A' && c <= 'Z'; }
bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\r' || c == '\n'; }
char to_upper(char c) { return c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c; }

/// Capital letters and digits only: no comments, no blanks.
std::string without_comments(std::string_view text) {
  std::string bare;
  bool in_comment = false;
  for (const char c : text) {
    if (c == ';' && !in_comment) break;
    if (c == '(') in_comment = true;
    if (!in_comment && !is_blank(c)) bare.push_back(to_upper(c));
    if (c == ')') in_comment = false;
  }
  return bare;
}

/// A number at the front of `text`, which then begins behind it.
std::optional<double> take_number(std::string_view& text) {
  std::string_view digits = text;
  if (!digits.empty() && digits.front() == '+') digits.remove_prefix(1);
  const std::size_t sign = !digits.empty() && digits.front() == '-' ? 1 : 0;
  // from_chars would also read "inf" and "nan".
  if (digits.size() <= sign || is_letter(digits[sign])) return std::nullopt;
  double value = 0.0;
  const auto [end, error] = std::from_chars(
      digits.data(), digits.data() + digits.size(), value, std::chars_format::fixed);
  if (error != std::errc{}) return std::nullopt;
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

}  // namespace

std::optional<double> ProgramLine::value(char letter) const {
  return values[static_cast<std::size_t>(letter - 'A')];
}

bool ProgramLine::has_g(int tenths) const { return std::ranges::find(g, tenths) != g.end(); }

bool ProgramLine::has_axis_words() const {
  return std::ranges::any_of(cnc::kAxisLetters,
                             [this](char letter) { return value(letter).has_value(); });
}

ProgramLine take_apart(std::string_view text) {
  ProgramLine line;
  const std::string bare = without_comments(text);
  if (bare.empty() || bare.front() == '/' || bare.front() == '%') return line;
  std::string_view rest = bare;
  while (!rest.empty()) {
    const char letter = rest.front();
    rest.remove_prefix(1);
    const std::optional<double> number = is_letter(letter) ? take_number(rest) : std::nullopt;
    if (!number) {
      line.faults.push_back(std::string{"not a word: "} + letter + std::string{rest});
      break;
    }
    add_word(line, letter, *number);
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

std::string_view take_line(std::string_view& text) {
  const std::size_t end = std::min(text.find_first_of("\r\n"), text.size());
  const std::string_view line = text.substr(0, end);
  const bool pair = text.substr(end, 2) == "\r\n";
  text.remove_prefix(std::min(end + (pair ? 2 : 1), text.size()));
  return line;
}

}  // namespace sim
