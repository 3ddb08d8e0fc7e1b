#pragma once

#include <span>
#include <string>
#include <string_view>

#include "host-sim/trace/output_file.hpp"
#include "host-sim/trace/trace_row.hpp"
#include "planner/base/axes.hpp"

namespace sim {

/// The line of column names, which separates the comments from the rows.
inline constexpr std::string_view kTraceColumns = "time_ns,x,y,z,a,b,c,s";

/// Writes the step trace (`--trace FILE`), one line of text for each row.
///
///     # <each comment>
///     # steps_per_mm X=80 Y=80 Z=400 A=10 B=10 C=10
///     time_ns,x,y,z,a,b,c,s
///     1000,1,0,0,0,0,0,0.5
///
/// Times are in ns, positions in motor steps, duties 0…1. A float is written with the fewest digits
/// from which the same float can be read. Thus equal runs give equal bytes. File-system errors
/// throw std::system_error with the name of the file, from the constructor, on_row() or on_end().
/// The file is complete after on_end().
class TraceWriter final : public TraceSink {
 public:
  /// Creates the file and writes its heading.
  /// @param steps_per_mm steps per mm; steps per degree for A, B and C
  /// @param comments a line break inside a comment becomes a space
  TraceWriter(const std::string& path,
              const cnc::AxisArray<float>& steps_per_mm,
              std::span<const std::string> comments = {});

  void on_row(const TraceRow& row) override;
  void on_end(std::uint64_t time_ns) override;

 private:
  OutputFile file_;
  /// Last duty. Its text is kept because the output changes far less often than the motors step.
  float duty_ = 0.0F;
  std::string duty_text_{"0"};  ///< Text of duty_.
};

}  // namespace sim
