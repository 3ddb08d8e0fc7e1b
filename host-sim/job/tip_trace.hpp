#pragma once

#include <optional>
#include <vector>

#include "firmware/machine/machine.hpp"
#include "host-sim/machine/five_axis_model.hpp"
#include "host-sim/measure/path_deviation.hpp"
#include "host-sim/report/report.hpp"
#include "host-sim/trace/trace_row.hpp"

namespace sim {

/// Computes the trace of the tool tip relative to the part, while G43.4 is active and rotary axes
/// lean the tool. At other times, it passes on the trace of the axes unchanged. The added sinks
/// receive rows in whole steps, and the meter of the path deviation receives exact positions.
class TipTrace final : public TraceSink {
 public:
  /// Begins a trace.
  /// @param machine machine that owns the axes, and gives the state of G43.4 and the tool length
  TipTrace(const cnc::Machine& machine, PathDeviation& deviation)
      : machine_{machine}, deviation_{deviation} {}

  /// Adds a sink for the rows. It must outlive this object.
  void add_sink(TraceSink& sink) { sinks_.push_back(&sink); }

  void on_row(const TraceRow& row) override;
  void on_end(std::uint64_t time_ns) override {
    for (TraceSink* sink : sinks_) sink->on_end(time_ns);
  }

  /// Returns the report on the tip under G43.4; empty if G43.4 was never active.
  [[nodiscard]] const std::optional<TipReport>& tip() const { return tip_; }

 private:
  void note(const ToolPose& tool);

  const cnc::Machine& machine_;
  PathDeviation& deviation_;
  std::vector<TraceSink*> sinks_;
  std::optional<FiveAxisModel> model_{};
  cnc::Coordinate tool_length_{};  ///< Tool length for which the model was made.
  /// Position, in steps, of the last row for which the model was used.
  cnc::AxisArray<std::int32_t> last_{};
  std::optional<TipReport> tip_{};
};

}  // namespace sim
