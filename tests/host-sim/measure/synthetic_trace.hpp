#pragma once

#include <functional>
#include <vector>

#include "host-sim/measure/curve.hpp"
#include "host-sim/trace/trace_row.hpp"

namespace sim {

/// A machine without faults: its motors step at the nanosecond at which the given motion crosses a
/// half step.
struct SyntheticMachine {
  cnc::AxisArray<double> steps_per_mm{80, 80, 80, 80, 80, 80};
  /// Greatest random delay of an edge, s.
  double jitter_s = 0.0;
  unsigned seed = 1;

  /// Returns the rows of a motion that begins at zero, from time 0 to `end_s`. Reversals faster
  /// than the scan of 20 µs are missed.
  [[nodiscard]] std::vector<TraceRow> rows(const std::function<Point(double)>& course,
                                           double end_s) const;
};

/// Passes the rows and the end to a sink.
void play(const std::vector<TraceRow>& rows, TraceSink& sink);

}  // namespace sim
