#include "firmware/link/line_check.hpp"

#include <algorithm>
#include <array>
#include <optional>
#include <span>

#include "planner/base/crc32.hpp"
#include "planner/gcode/line_reader.hpp"

namespace cnc {

/// A line whose check is right.
struct LineCheck::Checked {
  std::string_view covered;  ///< All before the `*`.
  Form form = Form::kNone;
  bool has_number = false;
  bool restarts = false;  ///< M110.
  std::uint32_t number = 0;
  std::string_view rest;  ///< After the number.
};

namespace {

constexpr std::size_t kCrcDigits = 8;
constexpr std::size_t kMostSumDigits = 3;
constexpr std::uint32_t kMostNumber = 9'999'999;  // What G-code's N takes.
constexpr std::uint32_t kRestart = 110;

constexpr bool is_digit(char c) { return c >= '0' && c <= '9'; }

std::string_view without_blanks(std::string_view text) {
  while (!text.empty() && gcode::is_blank(text.front())) text.remove_prefix(1);
  return text;
}

// string_view::substr throws, which nothing here may.
std::string_view before(std::size_t place, std::string_view text) {
  text.remove_suffix(text.size() - place);
  return text;
}

std::string_view from(std::size_t place, std::string_view text) {
  text.remove_prefix(place);
  return text;
}

/// Where the check begins: at the last `*`.
std::size_t star_of(std::string_view line) { return line.rfind('*'); }

/// In a comment a `*` means nothing to those who do not know of checks.
bool in_comment(std::string_view text) {
  bool within = false;
  for (const char c : text) {
    if (c == ';' && !within) return true;
    if (c == '(') within = true;
    if (c == ')') within = false;
  }
  return within;
}

/// What a sender who has not begun with checked lines means as one.
bool looks_checked(std::string_view line) {
  const std::string_view text = without_blanks(line);
  if (text.empty()) return false;
  const bool numbered = text.front() == 'N' || text.front() == 'n';
  if (!numbered && !text.starts_with("M110*")) return false;
  const std::size_t star = star_of(line);
  if (star == std::string_view::npos || in_comment(before(star, line))) return false;
  return !numbered || is_digit(without_blanks(from(1, text)).front());  // The star at the latest.
}

bool has_crc(std::string_view covered, std::string_view digits) {
  std::array<char, kCrcDigits> expected{};
  put_line_crc(covered, expected.data());
  return digits == std::string_view{expected.data(), expected.size()};
}

bool has_sum(std::string_view covered, std::string_view digits) {
  if (digits.empty() || digits.size() > kMostSumDigits) return false;
  std::uint32_t written = 0;
  for (const char c : digits) {
    if (!is_digit(c)) return false;
    written = 10 * written + static_cast<std::uint32_t>(c - '0');
  }
  std::uint32_t sum = 0;
  for (const char c : covered) sum ^= static_cast<std::uint8_t>(c);
  return written == sum;
}

std::optional<std::uint32_t> whole_number(const gcode::Decimal& value) {
  if (!value.is_integer() || value.is_negative() || value.whole > kMostNumber) return std::nullopt;
  return value.whole;
}

/// M110, and the N after it in place of `number`.
bool says_restart(std::string_view text, std::uint32_t& number) {
  if (text.empty() || (text.front() != 'M' && text.front() != 'm')) return false;
  gcode::LineReader reader{text};
  gcode::Word word{};
  if (reader.begin(false) || reader.at_end() || reader.read(word)) return false;
  if (!word.value.is_integer() || word.value.whole != kRestart) return false;
  if (reader.at_end()) return true;
  const bool another = !reader.read(word) && word.letter == 'N' && reader.at_end();
  const auto count = whole_number(word.value);
  if (!another || !count) return false;
  number = *count;
  return true;
}

}  // namespace

void put_line_crc(std::string_view covered, char* digits) {
  constexpr std::string_view kHexadecimal = "0123456789ABCDEF";
  Crc32 crc;
  crc.add(std::as_bytes(std::span{covered}));
  std::uint32_t value = crc.value();
  for (std::size_t i = kCrcDigits; i > 0; --i, value >>= 4U)
    digits[i - 1] = kHexadecimal[value & 15U];
}

LineCheck::Judgement LineCheck::judge(std::string_view line, bool whole, hal::TickCount now) {
  attend(now);
  numbered_ = false;
  if (!strict() && (!whole || !looks_checked(line))) {
    return {.verdict = Verdict::kTake, .text = line};
  }
  const std::size_t star = whole ? star_of(line) : std::string_view::npos;
  if (star != std::string_view::npos) {
    const std::string_view digits = from(star + 1, line);
    Checked checked{.covered = before(star, line), .rest = {}};
    if (digits.size() == kCrcDigits && has_crc(checked.covered, digits)) {
      checked.form = Form::kCrc;
    } else if (has_sum(checked.covered, digits)) {
      checked.form = Form::kSum;
    }
    if (checked.form != Form::kNone) return take(checked, now);
  }
  return {.verdict = ask(wanted_, now)};
}

LineCheck::Judgement LineCheck::take(const Checked& checked, hal::TickCount now) {
  std::string_view rest = without_blanks(checked.covered);
  std::optional<std::uint32_t> number;
  if (!rest.empty() && (rest.front() == 'N' || rest.front() == 'n')) {
    const auto reading = gcode::read_decimal(from(1, rest));
    if (reading.ok()) {
      number = whole_number(reading.value().value);
      rest.remove_prefix(1 + reading.value().length);
    }
  }
  std::uint32_t count = number.value_or(0);
  const bool restarts = says_restart(without_blanks(rest), count);
  const bool same_form = form_ == Form::kNone || form_ == checked.form;
  if (restarts && (number || checked.form == Form::kCrc) &&
      (same_form || checked.form == Form::kCrc)) {
    *this = {};
    since_ = now;
    if (!number) return {.verdict = Verdict::kBegin};
    form_ = checked.form;
    wanted_ = count + 1;
    numbered_ = form_ == Form::kCrc;
    return {.verdict = Verdict::kBegin};
  }
  if (!number || !same_form) return {.verdict = ask(wanted_, now)};
  form_ = checked.form;
  lapsed_ = false;
  if (*number != wanted_) return {.verdict = ask(*number, now)};
  ++wanted_;
  said_ = Verdict::kTake;
  since_ = now;
  numbered_ = form_ == Form::kCrc;
  rest = without_blanks(rest);
  const bool statement = !rest.empty() && rest.front() == '$';
  return {.verdict = Verdict::kTake, .text = statement ? rest : checked.covered};
}

/// Once for what is missing. Numbers that do not rise any more say that the sender has begun
/// anew, and that what it was asked for was lost again.
LineCheck::Verdict LineCheck::ask(std::uint32_t number, hal::TickCount now) {
  const Verdict verdict = number < wanted_ ? Verdict::kRepeated : Verdict::kMissing;
  const bool news = said_ == Verdict::kTake || (verdict == Verdict::kMissing && said_ != verdict);
  const bool anew = number != wanted_ && number <= dropped_;
  dropped_ = news || anew ? number : std::max(dropped_, number);
  if (!news && !anew && now.since(since_) < kAskAgainUs) return Verdict::kDrop;
  said_ = verdict;
  since_ = now;
  return verdict;
}

}  // namespace cnc
