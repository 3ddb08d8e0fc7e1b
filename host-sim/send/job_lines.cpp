#include "host-sim/send/job_lines.hpp"

#include "planner/gcode/block.hpp"
#include "planner/gcode/decimal.hpp"

namespace sim {
namespace {

using cnc::gcode::is_blank;

/// What is left of a line of G-code; an open comment ends with the line.
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

}  // namespace

std::vector<JobLine> read_job(std::string_view program) {
  std::vector<JobLine> lines;
  std::size_t number = 1;
  std::string_view rest = program;
  while (!rest.empty()) {
    const std::size_t end = rest.find_first_of("\r\n");
    std::string text = worth_sending(rest.substr(0, end));
    if (!text.empty()) lines.push_back({.text = std::move(text), .number = number});
    if (end == std::string_view::npos) break;
    const bool pair = rest.substr(end, 2) == "\r\n";
    rest.remove_prefix(end + (pair ? 2 : 1));
    ++number;
  }
  return lines;
}

void number_lines(std::vector<JobLine>& job) {
  std::uint32_t n = 0;
  for (JobLine& line : job) {
    line.n = ++n;
    if (line.text.front() != 'N' && line.text.front() != 'n') continue;
    const std::size_t end = line.text.find_first_not_of("0123456789", 1);
    line.text.erase(0, end == std::string::npos ? line.text.size() : end);
  }
}

}  // namespace sim
