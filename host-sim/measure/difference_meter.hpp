#pragma once

#include <array>
#include <cstddef>
#include <limits>
#include <optional>

namespace sim {

/// Position of an axis at an instant, as far as its pulses show it: between low and high.
struct AxisFix {
  double time_s = 0.0;
  double low = 0.0;
  double high = 0.0;

  [[nodiscard]] bool exact() const { return low == high; }
};

/// Measures the greatest speed, acceleration or jerk of one axis (order 1, 2 or 3) that its pulses
/// prove, over windows of time.
///
/// A motor steps when the ideal position crosses a half step, so that the position at an edge is
/// known exactly, with no quantisation. A divided difference over order + 1 edges that lie at least
/// a window apart is a weighted mean of the derivative with weights ≥ 0 (Hermite–Genocchi). Thus it
/// never exceeds the true maximum, however sparse the steps are. Between two edges only the step on
/// which the motor rests is known; such fixes are intervals, and the least value that they allow
/// counts. Interval fixes reveal sudden stops and starts; exact fixes reveal slow speeds.
///
/// Only an error ε in the edges' time adds to the result: at most 2^order · v · ε / window^order at
/// speed v. 25 µs at 100 mm/s over 10 ms make 0.5 mm/s and 100 mm/s². A motion shorter than a
/// window is averaged over it.
class DifferenceMeter {
 public:
  DifferenceMeter(std::size_t order, double window_s) : order_{order}, window_s_{window_s} {}

  /// Adds an edge: the axis crossed `position` at this time, and was between low and high since the
  /// edge before.
  /// @pre the time is later than that of the edge before
  void add_edge(double time_s, double position, double low, double high);

  /// Ends the measurement: no more edges follow, and the axis stays between low and high.
  void finish(double low, double high);

  [[nodiscard]] double greatest() const { return greatest_; }
  /// Returns the end of the windows in which the greatest value was measured; 0 before any.
  [[nodiscard]] double time_of_greatest_s() const { return time_s_; }

 private:
  // Capacity for three windows and the gap between them, with two fixes in each sixteenth of a
  // window.
  static constexpr std::size_t kCapacity = 128;
  static constexpr double kFixesPerWindow = 16.0;

  void add(const AxisFix& fix);
  void settle_latest();
  /// Measures with the newest fix and older ones: with all of them, or only with the exact ones.
  void measure(bool exact_only);
  /// Returns the latest fix that is at least a window older than the fix of age `age`. Ages count
  /// back from the newest fix.
  [[nodiscard]] std::optional<std::size_t> window_before(std::size_t age, bool exact_only) const;
  [[nodiscard]] const AxisFix& fix(std::size_t age) const;

  std::size_t order_;
  double window_s_;
  std::array<AxisFix, kCapacity> fixes_{};
  std::size_t count_ = 0;
  /// The last edge. It is added to the fixes if it is far enough from them or if the axis pauses
  /// after it.
  std::optional<AxisFix> latest_;
  double greatest_ = 0.0;
  double time_s_ = 0.0;
};

}  // namespace sim
