#include "planner/gcode/line_reader.hpp"

namespace cnc::gcode {

namespace {

constexpr char upper_case(char c) {
  return c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c;
}

constexpr bool is_line_end(char c) { return c == '\r' || c == '\n'; }

constexpr bool is_visible_ascii(char c) { return c > ' ' && c <= '~'; }

constexpr bool is_digit(char c) { return c >= '0' && c <= '9'; }

/// Returns whether a character begins an expression or a parameter in LinuxCNC or Fanuc.
constexpr bool begins_expression(char c) { return c == '[' || c == '#' || c == '<'; }

}  // namespace

std::string_view without_mark(std::string_view line) {
  if (line.starts_with("\xef\xbb\xbf")) line.remove_prefix(3);
  return line;
}

Refusal LineReader::begin(bool block_delete) {
  drop_line_end();
  at_ = line_.size() - without_mark(line_).size();
  if (too_long()) {
    return Fault{.detail = FaultDetail::kLineTooLong,
                 .column = kLongestLine + 1,
                 .limit = static_cast<float>(kLongestLine)};
  }
  if (const auto fault = skip_to_word()) return fault;
  if (at('/')) return pass_slash(block_delete);
  if (at('%')) return pass_percent();
  first_ = at_;
  return std::nullopt;
}

Refusal LineReader::read(Word& word) {
  const char letter = at(':') && at_ == first_ ? 'O' : upper_case(line_[at_]);
  if (letter < 'A' || letter > 'Z') return not_a_letter();
  return read_value(letter, word);
}

/// Returns whether the line is too long. Only text outside comments counts, because a file may have
/// long comments but the machine's memory for a line is limited.
bool LineReader::too_long() const {
  if (line_.size() <= kLongestLine) return false;
  std::size_t code = 0;
  bool within = false;
  for (const char c : line_) {
    if (c == ';' && !within) break;
    if (c == '(') within = true;
    if (!within) ++code;
    if (c == ')') within = false;
  }
  return code > kLongestLine || line_.size() > kLongestLineWithComments;
}

/// Reads the number after the letter or colon at the present index.
Refusal LineReader::read_value(char letter, Word& word) {
  std::string_view rest = line_;
  rest.remove_prefix(at_ + 1);  // Used instead of substr(), which can throw.
  const auto number = read_decimal(rest);
  word.letter = letter;
  word.column = static_cast<std::uint16_t>(at_ + 1);
  if (!number.ok()) return no_number(letter, number.error());
  word.value = number.value().value;
  at_ += 1 + number.value().length;
  return skip_to_word();
}

void LineReader::drop_line_end() {
  while (!line_.empty() && is_line_end(line_.back())) line_.remove_suffix(1);
}

Refusal LineReader::skip_to_word() {
  while (!at_end()) {
    if (is_blank(line_[at_])) {
      ++at_;
    } else if (line_[at_] == '(') {
      if (const auto fault = skip_comment()) return fault;
    } else if (line_[at_] == ';') {
      at_ = line_.size();
    } else {
      break;
    }
  }
  return std::nullopt;
}

/// Skips a comment. The comment must be closed and must not contain a left parenthesis (RS274/NGC
/// 3.3.4).
Refusal LineReader::skip_comment() {
  const Fault unclosed = fault_here(FaultDetail::kUnclosedComment);
  for (++at_; !at_end(); ++at_) {
    if (at('(')) return fault_here(FaultDetail::kNestedComment);
    if (at(')')) {
      ++at_;
      return std::nullopt;
    }
  }
  return unclosed;
}

Refusal LineReader::pass_slash(bool block_delete) {
  if (block_delete) {
    at_ = line_.size();
    return std::nullopt;
  }
  ++at_;
  if (!at_end() && is_digit(line_[at_])) ++at_;
  first_ = at_ + 1;  // A colon after the slash does not count as the first character of the line.
  return skip_to_word();
}

/// Skips a line that begins with %. The text after % is the name of a program. A G word in this
/// text is refused as a mistake, because it would not be executed.
Refusal LineReader::pass_percent() {
  const Fault not_alone = fault_here(FaultDetail::kPercentNotAlone);
  ++at_;
  if (const auto fault = skip_to_word()) return fault;
  const bool word =
      line_.size() > at_ + 1 && upper_case(line_[at_]) == 'G' && is_digit(line_[at_ + 1]);
  if (word) return not_alone;
  at_ = line_.size();
  return std::nullopt;
}

Fault LineReader::fault_here(FaultDetail detail) const {
  return Fault{.detail = detail, .column = static_cast<std::uint16_t>(at_ + 1)};
}

Fault LineReader::no_number(char letter, DecimalError error) const {
  Fault fault = fault_here(FaultDetail::kNumberTooLong);
  fault.letter = letter;
  if (error == DecimalError::kTooLong) return fault;
  fault.detail = letter == 'O' ? FaultDetail::kOWord : FaultDetail::kNumberMissing;
  std::size_t next = at_ + 1;
  while (next < line_.size() && is_blank(line_[next])) ++next;
  if (letter != 'O' && next < line_.size() && begins_expression(line_[next])) {
    fault.detail = FaultDetail::kExpressionForNumber;
  }
  return fault;
}

Fault LineReader::not_a_letter() const {
  const char found = line_[at_];
  if (is_visible_ascii(found)) {
    Fault fault =
        fault_here(begins_expression(found) ? FaultDetail::kExpression : FaultDetail::kNotALetter);
    fault.letter = found;
    return fault;
  }
  Fault fault = fault_here(FaultDetail::kForeignByte);
  fault.value = static_cast<float>(static_cast<unsigned char>(found));
  return fault;
}

}  // namespace cnc::gcode
