#include "host-sim/send/job_lines.hpp"

#include <limits>
#include <stdexcept>

#include "planner/gcode/block.hpp"
#include "planner/gcode/decimal.hpp"

namespace sim {
namespace {

using cnc::gcode::is_blank;

/// Returns the G-code of a line without comments and blanks. A comment that is not closed ends with
/// the line.
std::string code_of(std::string_view line) {
  std::string kept;
  bool comment = false;
  for (const char c : line) {
    if (c == ';' && !comment) break;
    if (c == '(') comment = true;
    if (!comment && !is_blank(c)) kept += c;
    if (c == ')') comment = false;
  }
  return kept;
}

std::string worth_sending(std::string_view line) {
  while (!line.empty() && is_blank(line.front())) line.remove_prefix(1);
  while (!line.empty() && is_blank(line.back())) line.remove_suffix(1);
  if (line.starts_with('$')) return std::string{line};
  cnc::gcode::Block block;
  const bool nothing = !cnc::gcode::read_block(line, false, block) && block.empty();
  return nothing ? std::string{} : code_of(line);
}

/// Removes the program's own line number, which the sender's number replaces.
std::string_view without_number(std::string_view line) {
  if (line.front() != 'N' && line.front() != 'n') return line;
  const std::size_t end = line.find_first_not_of("0123456789", 1);
  return line.substr(end == std::string_view::npos ? line.size() : end);
}

}  // namespace

JobLines::JobLines(const std::vector<JobLine>& lines) {
  for (const JobLine& line : lines) {
    add(line.text, line.number);
    given_.push_back(line.n);
  }
}

void JobLines::add(std::string_view text, std::size_t number) {
  constexpr std::size_t kMax = std::numeric_limits<std::uint32_t>::max();
  if (text_.size() + text.size() > kMax || number > kMax) {
    throw std::length_error("the job has more than 4 GiB of text: send it in parts");
  }
  text_ += numbered_ ? without_number(text) : text;
  ends_.push_back(static_cast<std::uint32_t>(text_.size()));
  numbers_.push_back(static_cast<std::uint32_t>(number));
}

JobLine JobLines::operator[](std::size_t index) const {
  const std::size_t begin = index == 0 ? 0 : ends_[index - 1];
  JobLine line{.text = text_.substr(begin, ends_[index] - begin), .number = numbers_[index]};
  if (numbered_) line.n = static_cast<std::uint32_t>(index + 1);
  if (!given_.empty()) line.n = given_[index];
  return line;
}

JobLine JobPart::operator[](std::size_t index) const {
  JobLine line = (*lines)[first + index];
  if (index == 0) line.text.insert(0, motion);
  return line;
}

JobLines read_job(std::string_view program, bool numbered) {
  JobLines lines{numbered};
  std::size_t number = 1;
  std::string_view rest = program;
  while (!rest.empty()) {
    const std::size_t end = rest.find_first_of("\r\n");
    const std::string text = worth_sending(rest.substr(0, end));
    if (!text.empty()) lines.add(text, number);
    if (end == std::string_view::npos) break;
    const bool pair = rest.substr(end, 2) == "\r\n";
    rest.remove_prefix(end + (pair ? 2 : 1));
    ++number;
  }
  return lines;
}

std::optional<JobLine> line_too_long(const JobLines& job, std::size_t most) {
  for (std::size_t index = 0; index < job.size(); ++index) {
    if (job.length_of(index) > most) return job[index];
  }
  return std::nullopt;
}

}  // namespace sim
