#pragma once

#include <cstddef>
#include <fstream>
#include <string>
#include <string_view>
#include <vector>

#include "host-sim/trace/trace_row.hpp"
#include "planner/base/axes.hpp"

namespace sim {

/// Reads a step trace row by row and returns exactly the rows that TraceWriter was given.
///
/// A file that cannot be opened or that breaks the format (a missing scale, a wrong column, a time
/// that does not increase) throws std::runtime_error with `file:line: message`.
class TraceReader {
 public:
  explicit TraceReader(const std::string& path);

  /// Returns the comment lines, except the scale, without their leading `# `.
  [[nodiscard]] const std::vector<std::string>& comments() const { return comments_; }
  /// Returns the scale: steps per mm for X, Y and Z; steps per degree for A, B and C.
  [[nodiscard]] const cnc::AxisArray<float>& steps_per_mm() const { return steps_per_mm_; }

  /// Reads the next row. Returns false at the end of the file, and leaves `row` unchanged there.
  [[nodiscard]] bool next(TraceRow& row);

 private:
  [[nodiscard]] bool next_line();
  void read_comment(std::string_view text);
  void read_scale(std::string_view items);
  [[noreturn]] void fail(const char* message) const;

  std::string path_;
  std::ifstream file_;
  std::string line_;
  std::size_t line_number_ = 0;
  std::size_t first_row_line_ = 0;
  std::uint64_t last_time_ns_ = 0;
  std::vector<std::string> comments_;
  cnc::AxisArray<float> steps_per_mm_{};
};

/// Returns all rows of a trace, for tests and short jobs. Throws as TraceReader does.
[[nodiscard]] std::vector<TraceRow> read_trace_rows(const std::string& path);

}  // namespace sim
