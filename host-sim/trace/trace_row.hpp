#pragma once

#include <cstdint>

#include "planner/base/axes.hpp"

namespace sim {

/// State of the simulated pins from `time_ns` on. A trace has one row for each time at which a
/// motor steps or the beam or spindle output changes.
struct TraceRow {
  std::uint64_t time_ns = 0;                ///< Time since the start of the run.
  cnc::AxisArray<std::int32_t> position{};  ///< Absolute motor positions in steps.
  float duty = 0.0F;                        ///< Beam or spindle output, 0…1.
};

/// Base of all consumers of the motion: writers, meters, pictures. Rows arrive in order of time, at
/// most one for each instant, and each row is complete.
class TraceSink {
 public:
  virtual void on_row(const TraceRow& row) = 0;
  /// Called after the last row, with the time at which the run ended.
  virtual void on_end(std::uint64_t time_ns) { static_cast<void>(time_ns); }

 protected:
  ~TraceSink() = default;
};

}  // namespace sim
