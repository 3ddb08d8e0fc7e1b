#pragma once

#include <optional>
#include <string>

#include "host-sim/trace/trace_row.hpp"
#include "host-sim/trace/trace_writer.hpp"

namespace sim {

/// The step trace of `kerfline serve`. If the file cannot be written any more, the trace ends with
/// a message and the machine continues.
class ServedTrace final : public TraceSink {
 public:
  /// Throws as the constructor of TraceWriter does.
  ServedTrace(const std::string& path, const cnc::AxisArray<float>& steps_per_mm);

  void on_row(const TraceRow& row) override;
  void on_end(std::uint64_t time_ns) override;
  /// Returns whether writing the file failed, so that the trace is incomplete.
  [[nodiscard]] bool lost() const { return !file_; }

 private:
  template <typename Write>
  void attempt(Write&& write);

  std::optional<TraceWriter> file_;  ///< Writer of the file; empty once the file cannot be written.
};

}  // namespace sim
