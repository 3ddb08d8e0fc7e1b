#pragma once

#include <array>
#include <cstddef>
#include <limits>
#include <optional>

namespace sim {

/// The place of an axis at an instant, as far as its pulses tell: between low and high.
struct AxisFix {
  double time_s = 0.0;
  double low = 0.0;
  double high = 0.0;

  [[nodiscard]] bool exact() const { return low == high; }
};

/// The greatest speed, acceleration or jerk of one axis (order 1, 2 or 3) that
/// its pulses prove, over windows of time.
///
/// A motor steps when the ideal position crosses a half step, so the place at an edge is
/// known exactly, with no quantisation. A divided difference over order + 1 edges
/// that lie at least a window apart is a weighted mean of the derivative with weights
/// ≥ 0 (Hermite–Genocchi), so it never exceeds the true maximum, be the steps as sparse
/// as they like. Where the motor stands between two edges, only the step it
/// stands on is known; such fixes are intervals, and the least value that they allow
/// counts. With them sudden stops and starts are seen, too; without them slow speeds.
///
/// Only an error ε in the edges' time adds to the result: at most
/// 2^order · v · ε / window^order at speed v. 25 µs at 100 mm/s over 10 ms make
/// 0.5 mm/s and 100 mm/s². What lasts less than a window is averaged over it.
class DifferenceMeter {
 public:
  DifferenceMeter(std::size_t order, double window_s) : order_{order}, window_s_{window_s} {}

  /// The axis crossed `position` at this time and was from low to high ever since the
  /// edge before. Times increase.
  void add_edge(double time_s, double position, double low, double high);

  /// No more edges: the axis stays from low to high.
  void finish(double low, double high);

  [[nodiscard]] double greatest() const { return greatest_; }
  /// The end of the windows of the greatest value; 0 before any.
  [[nodiscard]] double time_of_greatest_s() const { return time_s_; }

 private:
  // Two fixes in each sixteenth of a window, of three windows, and the gap between.
  static constexpr std::size_t kCapacity = 128;
  static constexpr double kFixesPerWindow = 16.0;

  void add(const AxisFix& fix);
  void settle_latest();
  /// With the newest fix and older ones, all or only the exact ones.
  void measure(bool exact_only);
  /// The latest fix at least a window older; counts back from the newest.
  [[nodiscard]] std::optional<std::size_t> window_before(std::size_t age, bool exact_only) const;
  [[nodiscard]] const AxisFix& fix(std::size_t age) const;

  std::size_t order_;
  double window_s_;
  std::array<AxisFix, kCapacity> fixes_{};
  std::size_t count_ = 0;
  /// The last edge. It joins the others when it is a fair distance from them or
  /// the axis pauses after it.
  std::optional<AxisFix> latest_;
  double greatest_ = 0.0;
  double time_s_ = 0.0;
};

}  // namespace sim
