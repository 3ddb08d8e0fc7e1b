#pragma once

#include <cstddef>
#include <fstream>
#include <string>
#include <string_view>
#include <vector>

#include "host-sim/trace/trace_row.hpp"
#include "planner/base/axes.hpp"

namespace sim {

/// Reads a step trace row by row. Returns exactly the rows that TraceWriter received.
///
/// Throws std::runtime_error with `file:line: message` for a file that cannot be opened or violates
/// the format (a missing scale, a wrong column, a time that does not increase).
class TraceReader {
 public:
  explicit TraceReader(const std::string& path);

  /// Returns the comment lines, without the line of the scale and without their leading `# `.
  [[nodiscard]] const std::vector<std::string>& comments() const { return comments_; }
  /// Returns the scale: steps per mm for X, Y and Z; steps per degree for A, B and C.
  [[nodiscard]] const cnc::AxisArray<float>& steps_per_mm() const { return steps_per_mm_; }

  /// Reads the next row. At the end of the file, returns false and leaves `row` unchanged.
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

/// Returns all rows of a trace; for tests and short jobs. Throws the exceptions of TraceReader.
[[nodiscard]] std::vector<TraceRow> read_trace_rows(const std::string& path);

}  // namespace sim
