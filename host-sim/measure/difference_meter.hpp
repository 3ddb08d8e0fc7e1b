#pragma once

#include <array>
#include <cstddef>
#include <limits>
#include <optional>

namespace sim {

/// Range of an axis's position at an instant, as far as the axis's pulses determine it: from `low`
/// to `high`.
struct AxisFix {
  double time_s = 0.0;
  double low = 0.0;
  double high = 0.0;

  [[nodiscard]] bool exact() const { return low == high; }
};

/// Measures the greatest speed, acceleration or jerk of one axis (order 1, 2 or 3) that its pulses
/// prove, over windows of time.
///
/// A motor steps when the ideal position crosses a half step. Therefore the position at an edge is
/// known exactly, without quantisation. Take order + 1 edges that are at least a window apart.
/// Their divided difference is a weighted mean of the derivative with weights ≥ 0
/// (Hermite–Genocchi). Thus it never exceeds the true maximum, even if the steps are sparse.
/// Between two edges, only the motor's step is known. Such fixes are intervals, and the least value
/// within them counts. Interval fixes reveal sudden stops and starts; exact fixes reveal slow
/// speeds.
///
/// Only an error ε of the edges' times can increase the result: at most by 2^order · v · ε /
/// window^order at the speed v. For example, 25 µs at 100 mm/s over 10 ms add 0.5 mm/s and 100
/// mm/s². A motion shorter than a window is averaged over the window.
class DifferenceMeter {
 public:
  DifferenceMeter(std::size_t order, double window_s) : order_{order}, window_s_{window_s} {}

  /// Adds an edge: the axis crossed `position` at this time. Since the previous edge, the axis was
  /// between `low` and `high`.
  /// @pre the time is later than the time of the previous edge
  void add_edge(double time_s, double position, double low, double high);

  /// Ends the measurement. No edges may follow; the axis stays between `low` and `high`.
  void finish(double low, double high);

  [[nodiscard]] double greatest() const { return greatest_; }
  /// Returns the end of the windows in which the greatest value was measured, s; 0 before the first
  /// measured value.
  [[nodiscard]] double time_of_greatest_s() const { return time_s_; }

 private:
  // Greatest number of stored fixes. They cover three windows and the gap between them, with two
  // fixes in each sixteenth of a window.
  static constexpr std::size_t kCapacity = 128;
  static constexpr double kFixesPerWindow = 16.0;

  void add(const AxisFix& fix);
  void settle_latest();
  /// Computes the difference that ends at the newest fix, from all fixes or only from the exact
  /// ones.
  void measure(bool exact_only);
  /// Returns the age of the latest fix that is at least a window older than the fix of age `age`;
  /// none if there is no such fix. An age counts fixes back from the newest fix.
  [[nodiscard]] std::optional<std::size_t> window_before(std::size_t age, bool exact_only) const;
  [[nodiscard]] const AxisFix& fix(std::size_t age) const;

  std::size_t order_;
  double window_s_;
  std::array<AxisFix, kCapacity> fixes_{};
  std::size_t count_ = 0;
  /// The last edge. It becomes a fix if it is far enough from the last fix, or if the axis pauses
  /// after the edge.
  std::optional<AxisFix> latest_;
  double greatest_ = 0.0;
  double time_s_ = 0.0;
};

}  // namespace sim
