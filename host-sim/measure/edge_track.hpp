#pragma once

#include <deque>

namespace sim {

/// An axis crosses a half step, mm.
struct AxisEdge {
  double time_s = 0.0;
  double position = 0.0;  ///< Half way between the motor's places before and after.
  double rest = 0.0;      ///< The motor's place from now on.
};

/// The likely course of one axis between its edges, for measures that need all
/// axes at the same instant.
///
/// Between two edges it takes the parabola through them with the acceleration
/// that the neighbouring edges show, so a uniform acceleration is met exactly, also
/// where the axis turns round. Where the axis pauses it comes to rest on the motor's
/// place, and leaves it, as a uniform acceleration would have it. The course never
/// leaves the step that the motor stands on: the error is at most half a step
/// at a pause, a whole one at a reversal, and usually a small part of that.
class EdgeTrack {
 public:
  /// `window_s`: what is shorter than this need not be resolved. `start`: the
  /// place before the first edge.
  EdgeTrack(double window_s, double start) : window_s_{window_s}, start_{start} {}

  /// The half step to a rest takes at most this many windows: slower axes show as
  /// pauses, with an acceleration of at most step / (16 windows)².
  static constexpr double kLongestSettling = 16.0;

  /// Edges this near in the past may still change the course.
  [[nodiscard]] double lag_s() const { return 6.0 * kLongestSettling * window_s_; }

  /// Times increase.
  void add(const AxisEdge& edge);

  /// The course at a time at least lag_s() before whatever may still be added.
  /// Times never decrease; edges that are no longer needed are dropped.
  [[nodiscard]] double position_at(double time_s);

 private:
  [[nodiscard]] double speed_after(std::size_t index) const;
  [[nodiscard]] double settling_time_s(std::size_t index, double speed) const;
  [[nodiscard]] double between(std::size_t index, double time_s) const;
  [[nodiscard]] double parabola(std::size_t index, double time_s) const;
  [[nodiscard]] double arriving(std::size_t index, double time_s) const;
  [[nodiscard]] double leaving(std::size_t index, double time_s) const;

  double window_s_;
  double start_;
  std::deque<AxisEdge> edges_;  ///< At most three before the time last asked for.
};

}  // namespace sim
