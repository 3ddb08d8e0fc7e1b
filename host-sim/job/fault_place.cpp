#include "host-sim/job/fault_place.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace sim {
namespace {

constexpr std::string_view kLineEnds = "\r\n";

/// Removes the first line of a text, with its line end (CR, LF or CR LF).
void drop_line(std::string_view& text) {
  text.remove_prefix(std::min(text.find_first_of(kLineEnds), text.size()));
  text.remove_prefix(text.starts_with(kLineEnds) ? 2 : std::min<std::size_t>(1, text.size()));
}

}  // namespace

std::size_t first_word(std::string_view text, int line) {
  for (int before = 1; before < line && !text.empty(); ++before) drop_line(text);
  text = text.substr(0, text.find_first_of(kLineEnds));
  std::size_t column = text.find_first_not_of(" \t/");
  if (column != std::string_view::npos && (text[column] == 'N' || text[column] == 'n')) {
    column = text.find_first_not_of(" \t0123456789", column + 1);
  }
  return column == std::string_view::npos ? 0 : column + 1;
}

Fault fault_of(const std::string& file,
               const Refusal& refusal,
               const std::optional<RefusedBeside>& beside,
               std::string_view text) {
  Fault fault{file, refusal.line, refusal.column, refusal.number, refusal.reason};
  const bool of_path = refusal.reason.starts_with("since G41 or G42");
  if (!of_path || !beside || beside->line <= 0) return fault;
  fault.line = static_cast<std::size_t>(beside->line);
  fault.column = first_word(text, beside->line);
  if (beside->other_line > 0) fault.message += fmt::format(" of line {}", beside->other_line);
  return fault;
}

}  // namespace sim
