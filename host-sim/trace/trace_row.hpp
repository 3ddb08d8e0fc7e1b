#pragma once

#include <cstdint>

#include "planner/base/axes.hpp"

namespace sim {

/// State of the simulated pins from `time_ns` on. A trace has one row for each time at which a
/// motor steps, or the output of the beam or the spindle changes.
struct TraceRow {
  std::uint64_t time_ns = 0;                ///< Time since the start of the run.
  cnc::AxisArray<std::int32_t> position{};  ///< Absolute motor positions, steps.
  float duty = 0.0F;                        ///< Output of the beam or the spindle, 0…1.
};

/// Base class of all consumers of a trace: writers, meters, pictures. Rows arrive in order of time,
/// with at most one row for each instant. Each row contains the full state.
class TraceSink {
 public:
  virtual void on_row(const TraceRow& row) = 0;
  /// Called after the last row, with the time at which the run ended.
  virtual void on_end(std::uint64_t time_ns) { static_cast<void>(time_ns); }

 protected:
  ~TraceSink() = default;
};

}  // namespace sim
