#pragma once

#include <algorithm>
#include <vector>

#include "host-sim/machine/play_model.hpp"
#include "host-sim/trace/trace_row.hpp"

namespace sim {

/// Computes the trace of the tool: the motion of the motors minus the play of their axes. Passes
/// its rows on to its own sinks.
class ToolTrace final : public TraceSink {
 public:
  /// Begins the trace at step 0 of all axes.
  /// @param play play of the machine, after its first place()
  explicit ToolTrace(const PlayModel& play) : play_{play} {}

  /// Adds a sink, which must outlive this object.
  void add_sink(TraceSink& sink) { sinks_.push_back(&sink); }

  void on_row(const TraceRow& row) override {
    TraceRow tool = row;
    tool.position = play_.follow(row.position);
    for (std::size_t axis = 0; axis < lowest_.size(); ++axis) {
      lowest_[axis] = std::min(lowest_[axis], tool.position[axis]);
      highest_[axis] = std::max(highest_[axis], tool.position[axis]);
    }
    for (TraceSink* sink : sinks_) sink->on_row(tool);
  }
  void on_end(std::uint64_t time_ns) override {
    for (TraceSink* sink : sinks_) sink->on_end(time_ns);
  }

  /// Returns the lowest position of the tool, steps. 0 is the tool's first position.
  [[nodiscard]] const PlayModel::Steps& lowest() const { return lowest_; }
  [[nodiscard]] const PlayModel::Steps& highest() const { return highest_; }

 private:
  PlayModel play_;
  std::vector<TraceSink*> sinks_;
  PlayModel::Steps lowest_{};
  PlayModel::Steps highest_{};
};

}  // namespace sim
