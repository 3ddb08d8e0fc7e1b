#pragma once

#include <optional>
#include <vector>

#include "firmware/machine/machine.hpp"
#include "host-sim/machine/five_axis_model.hpp"
#include "host-sim/measure/path_deviation.hpp"
#include "host-sim/report/report.hpp"
#include "host-sim/trace/trace_row.hpp"

namespace sim {

/// The trace of the tip as the part sees it, where rotary axes lean the tool under G43.4; elsewhere
/// that of the axes as it is. Hands its rows to sinks of its own, in whole steps, and exact places
/// to a meter of the path.
class TipTrace final : public TraceSink {
 public:
  /// @param machine whose axes these are; it says whether G43.4 holds and how long the tool is
  TipTrace(const cnc::Machine& machine, PathDeviation& deviation)
      : machine_{machine}, deviation_{deviation} {}

  /// It must outlive this.
  void add_sink(TraceSink& sink) { sinks_.push_back(&sink); }

  void on_row(const TraceRow& row) override;
  void on_end(std::uint64_t time_ns) override {
    for (TraceSink* sink : sinks_) sink->on_end(time_ns);
  }

  /// Returns where the tip was under G43.4; nothing without it.
  [[nodiscard]] const std::optional<TipReport>& tip() const { return tip_; }

 private:
  void note(const ToolPose& tool);

  const cnc::Machine& machine_;
  PathDeviation& deviation_;
  std::vector<TraceSink*> sinks_;
  std::optional<FiveAxisModel> model_{};
  cnc::Coordinate tool_length_{};        ///< That the model has.
  cnc::AxisArray<std::int32_t> last_{};  ///< Steps of the last row that the model saw.
  std::optional<TipReport> tip_{};
};

}  // namespace sim
