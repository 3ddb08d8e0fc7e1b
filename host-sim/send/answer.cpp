#include "host-sim/send/answer.hpp"

#include <array>
#include <charconv>

#include "firmware/link/line_check.hpp"

namespace sim {
namespace {

constexpr std::size_t kCrcDigits = 8;

/// Removes a number from the front of the text and returns it; nothing if the text begins with no
/// number.
std::optional<std::uint32_t> take_count(std::string_view& text) {
  std::uint32_t number = 0;
  const auto result = std::from_chars(text.data(), text.data() + text.size(), number);
  if (result.ec != std::errc{}) return std::nullopt;
  text.remove_prefix(static_cast<std::size_t>(result.ptr - text.data()));
  return number;
}

bool take_prefix(std::string_view& text, std::string_view words) {
  if (!text.starts_with(words)) return false;
  text.remove_prefix(words.size());
  return true;
}

/// Returns whether the text ends with a star and its correct CRC, and removes both if so.
bool take_crc(std::string_view& text) {
  if (text.size() <= kCrcDigits || text[text.size() - kCrcDigits - 1] != '*') return false;
  const std::string_view covered = text.substr(0, text.size() - kCrcDigits - 1);
  std::array<char, kCrcDigits> digits{};
  cnc::put_line_crc(covered, digits.data());
  if (text.substr(covered.size() + 1) != std::string_view{digits.data(), digits.size()})
    return false;
  text = covered;
  return true;
}

void read_line_number(std::string_view text, Answer& answer) {
  if (take_prefix(text, " N")) answer.line = take_count(text);
}

/// Returns whether a field `F:` or `FS:` has a feed that is not 0.
bool moves(std::string_view text) {
  for (const std::string_view name : {"|FS:", "|F:"}) {
    const std::size_t begin = text.find(name);
    if (begin == std::string_view::npos) continue;
    const std::string_view feed = text.substr(begin + name.size());
    return feed.substr(0, feed.find_first_of(",|>")).find_first_of("123456789") !=
           std::string_view::npos;
  }
  return false;
}

/// Reads a status report, such as `<Run|MPos:0.000,0.000,0.000|Bf:15,128|…>`.
Answer read_status(std::string_view text) {
  Answer answer{.kind = AnswerKind::kStatus};
  answer.state = text.substr(0, text.find_first_of("|>"));
  answer.moves = moves(text);
  const std::size_t buffers = text.find("|Bf:");
  if (buffers == std::string_view::npos) return answer;
  std::string_view rest = text.substr(buffers + 4);
  if (take_count(rest) && take_prefix(rest, ",")) answer.waiting_room = take_count(rest);
  return answer;
}

/// Reads the options, such as `[OPT:V,15,128]`.
Answer read_options(std::string_view text) {
  Answer answer{.kind = AnswerKind::kOptions};
  const std::size_t comma = text.find(',');
  if (comma == std::string_view::npos) return answer;
  std::string_view rest = text.substr(comma + 1);
  if (take_count(rest) && take_prefix(rest, ",")) answer.waiting_room = take_count(rest);
  return answer;
}

}  // namespace

Answer read_answer(std::string_view line) {
  std::string_view rest = line;
  const bool checked = take_crc(rest);
  Answer answer{.checked = checked};
  if (take_prefix(rest, "ok")) {
    answer.kind = AnswerKind::kOk;
    answer.text = rest;
    read_line_number(rest, answer);
  } else if (take_prefix(rest, "error:")) {
    answer.kind = AnswerKind::kError;
    answer.code = take_count(rest).value_or(0);
    read_line_number(rest, answer);
  } else if (take_prefix(rest, "Resend: ")) {
    answer.kind = AnswerKind::kResend;
    answer.number = take_count(rest).value_or(0);
    read_line_number(rest, answer);
  } else if (take_prefix(rest, "ALARM:")) {
    answer.kind = AnswerKind::kAlarm;
    answer.code = take_count(rest).value_or(0);
  } else if (take_prefix(rest, "<")) {
    return read_status(rest);
  } else if (take_prefix(rest, "[OPT:")) {
    return read_options(rest);
  } else if (take_prefix(rest, "[MSG:")) {
    answer.kind = AnswerKind::kMessage;
    answer.text = rest.substr(0, rest.rfind(']'));
  } else if (rest.starts_with("Grbl")) {
    answer.kind = AnswerKind::kBanner;
  }
  return answer;
}

std::string with_crc(std::string line) {
  std::array<char, kCrcDigits> digits{};
  cnc::put_line_crc(line, digits.data());
  return line.append("*").append(digits.data(), digits.size());
}

}  // namespace sim
