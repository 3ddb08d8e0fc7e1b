#pragma once

#include <optional>
#include <vector>

#include "firmware/machine/machine.hpp"
#include "host-sim/machine/five_axis_model.hpp"
#include "host-sim/measure/path_deviation.hpp"
#include "host-sim/report/report.hpp"
#include "host-sim/trace/trace_row.hpp"

namespace sim {

/// Computes the trace of the tip as the part sees it, where rotary axes lean the tool under G43.4.
/// Elsewhere it passes the trace of the axes on unchanged. It hands rows in whole steps to sinks of
/// its own, and exact positions to a meter of the path.
class TipTrace final : public TraceSink {
 public:
  /// Begins a trace.
  /// @param machine owner of the axes; it states whether G43.4 holds and how long the tool is
  TipTrace(const cnc::Machine& machine, PathDeviation& deviation)
      : machine_{machine}, deviation_{deviation} {}

  /// Adds a sink, which must outlive this object.
  void add_sink(TraceSink& sink) { sinks_.push_back(&sink); }

  void on_row(const TraceRow& row) override;
  void on_end(std::uint64_t time_ns) override {
    for (TraceSink* sink : sinks_) sink->on_end(time_ns);
  }

  /// Returns the positions of the tip under G43.4; empty if G43.4 was not in use.
  [[nodiscard]] const std::optional<TipReport>& tip() const { return tip_; }

 private:
  void note(const ToolPose& tool);

  const cnc::Machine& machine_;
  PathDeviation& deviation_;
  std::vector<TraceSink*> sinks_;
  std::optional<FiveAxisModel> model_{};
  cnc::Coordinate tool_length_{};        ///< Tool length of the model.
  cnc::AxisArray<std::int32_t> last_{};  ///< Steps of the last row that the model saw.
  std::optional<TipReport> tip_{};
};

}  // namespace sim
