#include "host-sim/trace/trace_writer.hpp"

#include <fmt/compile.h>

#include <algorithm>
#include <string_view>

namespace sim {
namespace {

void append_comment(fmt::memory_buffer& out, std::string comment) {
  const auto is_break = [](char c) { return c == '\n' || c == '\r'; };
  std::replace_if(comment.begin(), comment.end(), is_break, ' ');
  fmt::format_to(fmt::appender(out), "# {}\n", comment);
}

void append_scale(fmt::memory_buffer& out, const cnc::AxisArray<float>& steps_per_mm) {
  out.append(std::string_view{"# steps_per_mm"});
  for (std::size_t axis = 0; axis < cnc::kAxisCount; ++axis) {
    fmt::format_to(fmt::appender(out), " {}={}", cnc::kAxisLetters[axis], steps_per_mm[axis]);
  }
  out.push_back('\n');
}

}  // namespace

TraceWriter::TraceWriter(const std::string& path,
                         const cnc::AxisArray<float>& steps_per_mm,
                         std::span<const std::string> comments)
    : file_{path} {
  for (const std::string& comment : comments) append_comment(file_.buffer(), comment);
  append_scale(file_.buffer(), steps_per_mm);
  fmt::format_to(fmt::appender(file_.buffer()), "{}\n", kTraceColumns);
}

void TraceWriter::on_row(const TraceRow& row) {
  if (row.duty != duty_) {
    duty_ = row.duty;
    duty_text_ = fmt::format("{}", duty_);
  }
  const auto& [x, y, z, a, b, c] = row.position;
  fmt::format_to(fmt::appender(file_.buffer()),
                 FMT_COMPILE("{},{},{},{},{},{},{},{}\n"),
                 row.time_ns,
                 x,
                 y,
                 z,
                 a,
                 b,
                 c,
                 duty_text_);
  file_.drain_when_full();
}

void TraceWriter::on_end(std::uint64_t /*time_ns*/) { file_.close(); }

}  // namespace sim
