#include "host-sim/job/program_marks.hpp"

#include <fmt/format.h>

#include <cctype>

namespace sim {
namespace {

constexpr std::string_view kBlanks = " \t\r";

bool is_digit_at(std::string_view text, std::size_t at) {
  return at < text.size() && std::isdigit(static_cast<unsigned char>(text[at])) != 0;
}

/// Returns whether a line gives the name of a program: `O1234`, alone or before a comment, or
/// `:1234`.
bool is_name(std::string_view text) {
  return (text.front() == 'O' || text.front() == 'o' || text.front() == ':') &&
         is_digit_at(text, 1);
}

bool is_comment(std::string_view text) { return text.front() == ';' || text.front() == '('; }

}  // namespace

std::optional<std::string> ProgramMarks::take(std::size_t line, std::string_view text) {
  const std::size_t front = text.find_first_not_of(kBlanks);
  if (front == std::string_view::npos) return std::nullopt;
  text.remove_prefix(front);
  if (is_name(text)) {
    if (has_content_ && named_line_ != 0) {
      return fmt::format(
          "a second program begins here, after the program of line {}; it is driven, too",
          named_line_);
    }
    if (named_line_ == 0) named_line_ = line;
    return std::nullopt;
  }
  if (text.front() == '%') {
    if (has_content_ && end_line_ == 0) end_line_ = line;
    return std::nullopt;
  }
  if (is_comment(text)) return std::nullopt;
  has_content_ = true;
  if (end_line_ == 0 || is_noted_) return std::nullopt;
  is_noted_ = true;
  return fmt::format(
      "the program continues after the % of line {}: the lines from here on are driven, too",
      end_line_);
}

}  // namespace sim
