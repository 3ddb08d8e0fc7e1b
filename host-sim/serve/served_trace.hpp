#pragma once

#include <optional>
#include <string>

#include "host-sim/trace/trace_row.hpp"
#include "host-sim/trace/trace_writer.hpp"

namespace sim {

/// The step trace of `kerfline serve`. A file that cannot be written any more ends with a message;
/// the machine goes on.
class ServedTrace final : public TraceSink {
 public:
  /// Throws as TraceWriter.
  ServedTrace(const std::string& path, const cnc::AxisArray<float>& steps_per_mm);

  void on_row(const TraceRow& row) override;
  void on_end(std::uint64_t time_ns) override;
  /// The file could not be written to its end.
  [[nodiscard]] bool lost() const { return !file_; }

 private:
  template <typename Write>
  void attempt(Write&& write);

  std::optional<TraceWriter> file_;  ///< Empty once it is lost.
};

}  // namespace sim
