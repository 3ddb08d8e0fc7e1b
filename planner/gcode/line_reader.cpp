#include "planner/gcode/line_reader.hpp"

namespace cnc::gcode {

namespace {

constexpr char upper_case(char c) {
  return c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c;
}

constexpr bool is_line_end(char c) { return c == '\r' || c == '\n'; }

constexpr bool is_visible_ascii(char c) { return c > ' ' && c <= '~'; }

FaultDetail detail_of(DecimalError error) {
  return error == DecimalError::kNoDigits ? FaultDetail::kNumberMissing
                                          : FaultDetail::kNumberTooLong;
}

}  // namespace

Refusal LineReader::begin(bool block_delete) {
  drop_line_end();
  if (line_.size() > kLongestLine) {
    return Fault{.detail = FaultDetail::kLineTooLong,
                 .column = kLongestLine + 1,
                 .limit = static_cast<float>(kLongestLine)};
  }
  if (const auto fault = skip_to_word()) return fault;
  if (at('/')) return pass_slash(block_delete);
  if (at('%')) return pass_percent();
  return std::nullopt;
}

Refusal LineReader::read(Word& word) {
  const char letter = upper_case(line_[at_]);
  if (letter < 'A' || letter > 'Z') return not_a_letter();
  return read_value(letter, word);
}

/// The number behind the letter or colon here.
Refusal LineReader::read_value(char letter, Word& word) {
  std::string_view rest = line_;
  rest.remove_prefix(at_ + 1);  // Not substr(), which throws.
  const auto number = read_decimal(rest);
  word.letter = letter;
  word.column = static_cast<std::uint16_t>(at_ + 1);
  if (!number.ok()) {
    Fault fault = fault_here(detail_of(number.error()));
    fault.letter = letter;
    return fault;
  }
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

/// RS274/NGC 3.3.4: a comment holds no left parenthesis and is closed.
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
  return skip_to_word();
}

Refusal LineReader::pass_percent() {
  const Fault not_alone = fault_here(FaultDetail::kPercentNotAlone);
  ++at_;
  if (const auto fault = skip_to_word()) return fault;
  if (!at_end()) return not_alone;
  return std::nullopt;
}

Fault LineReader::fault_here(FaultDetail detail) const {
  return Fault{.detail = detail, .column = static_cast<std::uint16_t>(at_ + 1)};
}

Fault LineReader::not_a_letter() const {
  const char found = line_[at_];
  if (is_visible_ascii(found)) {
    Fault fault = fault_here(FaultDetail::kNotALetter);
    fault.letter = found;
    return fault;
  }
  Fault fault = fault_here(FaultDetail::kForeignByte);
  fault.value = static_cast<float>(static_cast<unsigned char>(found));
  return fault;
}

}  // namespace cnc::gcode
