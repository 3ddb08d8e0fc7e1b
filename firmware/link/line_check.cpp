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
};

namespace {

constexpr std::size_t kCrcDigits = 8;
constexpr std::size_t kMostSumDigits = 3;
constexpr std::uint32_t kMostNumber = 9'999'999;  // What G-code's N takes.
constexpr std::uint32_t kMinusOne = ~std::uint32_t{0};
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

bool begins_with_number(std::string_view text) {
  return !text.empty() && (text.front() == 'N' || text.front() == 'n');
}

constexpr bool is_hex_digit(char c) {
  return is_digit(c) || (c >= 'A' && c <= 'F') || (c >= 'a' && c <= 'f');
}

/// One to three digits, or the eight of a CRC.
bool looks_like_check(std::string_view digits) {
  if (digits.size() == kCrcDigits) return true;
  return !digits.empty() && digits.size() <= kMostSumDigits &&
         std::ranges::all_of(digits, is_digit);
}

bool has_crc(std::string_view covered, std::string_view digits) {
  std::array<char, kCrcDigits> expected{};
  put_line_crc(covered, expected.data());
  return digits == std::string_view{expected.data(), expected.size()};
}

bool has_sum(std::string_view covered, std::string_view digits) {
  std::uint32_t written = 0;
  for (const char c : digits) written = 10 * written + static_cast<std::uint32_t>(c - '0');
  std::uint32_t sum = 0;
  for (const char c : covered) sum ^= static_cast<std::uint8_t>(c);
  return written == sum;
}

/// −1 is a number for M110: the next line is N0.
std::optional<std::uint32_t> whole_number(const gcode::Decimal& value) {
  constexpr gcode::Decimal kBeforeZero{.whole = 1, .minus = true};
  if (value == kBeforeZero) return kMinusOne;
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

std::optional<LineMark> find_mark(std::string_view line) {
  if (line.find('*') == std::string_view::npos) return std::nullopt;
  std::size_t star = std::string_view::npos;
  std::size_t end = 0;  // Of its digits.
  char closing = ' ';   // Of the comment or expression that is open.
  for (std::size_t i = 0; i < line.size(); ++i) {
    const char c = line[i];
    if (closing != ' ') {
      if (c == closing) closing = ' ';
    } else if (c == ';') {
      break;
    } else if (c == '(') {
      closing = ')';
    } else if (c == '*') {
      star = i;
      end = i + 1;
    } else if (end == i && is_hex_digit(c)) {
      ++end;
    } else if (!gcode::is_blank(c)) {
      if (c == '[') closing = ']';
      star = std::string_view::npos;
    }
  }
  if (star == std::string_view::npos) return std::nullopt;
  const LineMark mark{before(star, line), from(star + 1, before(end, line))};
  return looks_like_check(mark.digits) ? std::optional{mark} : std::nullopt;
}

namespace {

/// Where every line is checked its end is the check, whatever stands before it.
std::optional<LineMark> mark_at_end(std::string_view line) {
  if (line.size() <= kCrcDigits) return std::nullopt;
  const std::size_t star = line.size() - kCrcDigits - 1;
  if (line[star] != '*') return std::nullopt;
  return LineMark{before(star, line), from(star + 1, line)};
}

}  // namespace

LineMark::Form LineMark::form() const {
  if (digits.size() == kCrcDigits) return has_crc(covered, digits) ? Form::kCrc : Form::kNone;
  return has_sum(covered, digits) ? Form::kSum : Form::kNone;
}

LineCheck::Judgement LineCheck::judge(std::string_view line, bool whole, hal::TickCount now) {
  attend(now);
  numbered_ = false;
  const std::string_view text = without_blanks(line);
  const bool statement = !text.empty() && text.front() == '$';
  const bool may_be_checked = whole && (strict() || !statement);
  const auto mark = !may_be_checked ? std::nullopt : strict() ? mark_at_end(line) : find_mark(line);
  if (!mark) return judge_plain(line, text, now);
  const Checked checked{.covered = mark->covered, .form = mark->form()};
  if (checked.form != Form::kNone) return take(checked, now);
  if (active()) return {.verdict = ask(wanted_, now)};
  return {.verdict = Verdict::kWrong, .text = mark->covered};
}

LineCheck::Judgement LineCheck::judge_plain(std::string_view line,
                                            std::string_view text,
                                            hal::TickCount now) {
  if (strict() || (active() && begins_with_number(text))) return {.verdict = ask(wanted_, now)};
  std::uint32_t count = 0;
  if (!says_restart(text, count)) return {.verdict = Verdict::kTake, .text = line};
  *this = {};
  form_ = Form::kSum;
  lapsed_ = true;
  wanted_ = count + 1;
  return {.verdict = Verdict::kBegin};
}

LineCheck::Judgement LineCheck::take(const Checked& checked, hal::TickCount now) {
  std::string_view rest = without_blanks(checked.covered);
  std::optional<std::uint32_t> number;
  if (begins_with_number(rest)) {
    const auto reading = gcode::read_decimal(from(1, rest));
    if (reading.ok()) {
      number = whole_number(reading.value().value);
      rest.remove_prefix(1 + reading.value().length);
    }
  }
  std::uint32_t count = number.value_or(0);
  const bool restarts = says_restart(without_blanks(rest), count);
  const bool same_form = form_ == Form::kNone || form_ == checked.form;
  if (restarts && (same_form || checked.form == Form::kCrc)) {
    *this = {};
    since_ = now;
    if (!number && checked.form == Form::kCrc) return {.verdict = Verdict::kBegin};
    form_ = checked.form;
    wanted_ = count + 1;
    numbered_ = form_ == Form::kCrc;
    return {.verdict = Verdict::kBegin};
  }
  rest = without_blanks(rest);
  const bool statement = !rest.empty() && rest.front() == '$';
  const Judgement good{.verdict = Verdict::kTake, .text = statement ? rest : checked.covered};
  if (!active()) {
    const bool in_order = number && (form_ == Form::kCrc || *number == wanted_);
    if (form_ != checked.form || !in_order) return good;
  }
  if (!number || !same_form) return {.verdict = ask(wanted_, now)};
  lapsed_ = false;
  if (*number != wanted_) return {.verdict = ask(*number, now)};
  ++wanted_;
  said_ = Verdict::kTake;
  since_ = now;
  numbered_ = form_ == Form::kCrc;
  return good;
}

/// With the CRC once for what is missing. Numbers that do not rise any more say that the sender has
/// begun anew, and that what it was asked for was lost again.
LineCheck::Verdict LineCheck::ask(std::uint32_t number, hal::TickCount now) {
  const Verdict verdict = number < wanted_ ? Verdict::kRepeated : Verdict::kMissing;
  if (form_ == Form::kSum) return verdict;
  const bool news = said_ == Verdict::kTake || (verdict == Verdict::kMissing && said_ != verdict);
  const bool anew = number != wanted_ && number <= dropped_;
  dropped_ = news || anew ? number : std::max(dropped_, number);
  if (!news && !anew && now.since(since_) < kAskAgainUs) return Verdict::kDrop;
  said_ = verdict;
  since_ = now;
  return verdict;
}

}  // namespace cnc
