#include "host-sim/trace/trace_reader.hpp"

#include <fmt/format.h>

#include <charconv>
#include <stdexcept>
#include <system_error>

#include "host-sim/trace/trace_writer.hpp"

namespace sim {
namespace {

constexpr std::string_view kScaleName = "steps_per_mm";

/// Removes `text` from the beginning of `rest`. Returns false if `rest` does not begin with `text`.
bool take_text(std::string_view& rest, std::string_view text) {
  if (rest.substr(0, text.size()) != text) return false;
  rest.remove_prefix(text.size());
  return true;
}

/// Reads a number at the beginning of `rest` and removes it from `rest`. Returns false if `rest`
/// does not begin with a number that fits the type.
template <typename Number>
bool take_number(std::string_view& rest, Number& number) {
  const auto [end, error] = std::from_chars(rest.data(), rest.data() + rest.size(), number);
  if (error != std::errc{}) return false;
  rest.remove_prefix(static_cast<std::size_t>(end - rest.data()));
  return true;
}

bool parse_row(std::string_view rest, TraceRow& row) {
  if (!take_number(rest, row.time_ns)) return false;
  for (std::int32_t& steps : row.position) {
    if (!take_text(rest, ",") || !take_number(rest, steps)) return false;
  }
  return take_text(rest, ",") && take_number(rest, row.duty) && rest.empty();
}

}  // namespace

TraceReader::TraceReader(const std::string& path) : path_{path}, file_{path} {
  if (!file_) throw std::runtime_error{fmt::format("{}: cannot open", path_)};
  while (next_line() && !line_.empty() && line_.front() == '#') read_comment(line_);
  if (line_ != kTraceColumns) fail("expected the column names time_ns,x,y,z,a,b,c,s");
  if (steps_per_mm_.front() <= 0.0F) fail("no line `# steps_per_mm` before the column names");
  first_row_line_ = line_number_ + 1;
}

bool TraceReader::next(TraceRow& row) {
  if (!next_line()) return false;
  TraceRow parsed;
  if (!parse_row(line_, parsed)) fail("expected a time, six positions and a duty");
  if (line_number_ > first_row_line_ && parsed.time_ns <= last_time_ns_) {
    fail("time does not increase; rows must be in order of time");
  }
  last_time_ns_ = parsed.time_ns;
  row = parsed;
  return true;
}

bool TraceReader::next_line() {
  ++line_number_;
  if (std::getline(file_, line_)) return true;
  if (!file_.eof()) fail("cannot read");
  line_.clear();
  return false;
}

void TraceReader::read_comment(std::string_view text) {
  if (!take_text(text, "# ")) take_text(text, "#");
  if (text.substr(0, kScaleName.size()) == kScaleName) {
    read_scale(text.substr(kScaleName.size()));
  } else {
    comments_.emplace_back(text);
  }
}

void TraceReader::read_scale(std::string_view items) {
  for (std::size_t axis = 0; axis < cnc::kAxisCount; ++axis) {
    const std::string name{' ', cnc::kAxisLetters[axis], '='};
    const bool is_read = take_text(items, name) && take_number(items, steps_per_mm_[axis]);
    if (!is_read) fail("unreadable steps_per_mm; expected numbers for all six axes");
  }
}

void TraceReader::fail(const char* message) const {
  throw std::runtime_error{fmt::format("{}:{}: {}", path_, line_number_, message)};
}

std::vector<TraceRow> read_trace_rows(const std::string& path) {
  TraceReader reader{path};
  std::vector<TraceRow> rows;
  for (TraceRow row; reader.next(row);) rows.push_back(row);
  return rows;
}

}  // namespace sim
