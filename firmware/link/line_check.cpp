#include "firmware/link/line_check.hpp"

#include <algorithm>
#include <optional>

#include "planner/gcode/line_reader.hpp"

namespace cnc {

/// Result of reading a line in which `*` and digits were found: the part that the check covers, and
/// the form of the check.
struct LineCheck::Checked {
  std::string_view covered;  ///< Text before the `*`.
  Form form = Form::kNone;
};

namespace {

constexpr std::uint32_t kMaxNumber = 9'999'999;  // Greatest line number of G-code.
constexpr std::uint32_t kMinusOne = ~std::uint32_t{0};
constexpr std::uint32_t kRestart = 110;

std::string_view without_blanks(std::string_view text) {
  while (!text.empty() && gcode::is_blank(text.front())) text.remove_prefix(1);
  return text;
}

// Used instead of string_view::substr, which may throw, because exceptions are disabled.
std::string_view from(std::size_t place, std::string_view text) {
  text.remove_prefix(place);
  return text;
}

bool begins_with_number(std::string_view text) {
  return !text.empty() && (text.front() == 'N' || text.front() == 'n');
}

/// Returns `value` as a line number; nothing if it is no line number. M110 may have −1, after which
/// the next line is N0.
std::optional<std::uint32_t> whole_number(const gcode::Decimal& value) {
  constexpr gcode::Decimal kBeforeZero{.whole = 1, .minus = true};
  if (value == kBeforeZero) return kMinusOne;
  if (!value.is_integer() || value.is_negative() || value.whole > kMaxNumber) return std::nullopt;
  return value.whole;
}

/// Returns whether the line is M110, which restarts the count. If an N word follows M110, its value
/// replaces `number`.
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

LineCheck::Judgement LineCheck::judge(std::string_view line,
                                      const LongLineCheck* long_line,
                                      hal::TickCount now) {
  attend(now);
  numbered_ = false;
  const std::string_view text = without_blanks(line);
  const bool statement = !text.empty() && text.front() == '$';
  if (statement && !strict()) return judge_plain(line, text, now);
  const auto mark = strict() ? mark_at_end(line) : find_mark(line);
  // If bytes were dropped from the line, its `*` may be among them.
  const bool found = long_line != nullptr ? long_line->found(strict()) : mark.has_value();
  if (!found) return judge_plain(line, text, now);
  const Checked checked{.covered = mark ? mark->covered : line,
                        .form = long_line != nullptr ? long_line->form(strict()) : mark->form()};
  if (checked.form != Form::kNone) return take(checked, now);
  if (active()) return {.verdict = ask(wanted_, now)};
  return {.verdict = Verdict::kWrong, .text = checked.covered};
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

/// Decides whether to request a line. With the CRC, a missing line is requested once. If a later
/// line has a number that is not above the largest number of the dropped lines, the sender is
/// repeating lines and the requested line was lost again. It is then requested again.
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
