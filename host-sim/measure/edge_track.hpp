#pragma once

#include <deque>

namespace sim {

/// Instant at which an axis crosses a half step. Lengths are in mm.
struct AxisEdge {
  double time_s = 0.0;
  double position = 0.0;  ///< Mean of the motor's positions before and after the step.
  double rest = 0.0;      ///< Position of the motor after the step.
};

/// Estimates the course of one axis between its edges, for measures that require all axes at the
/// same instant.
///
/// Between two edges, the course is the parabola through them, with the acceleration that the
/// neighbouring edges show. Thus a uniform acceleration is reproduced exactly, also where the axis
/// reverses. Where the axis pauses, the course comes to rest at the motor's position and leaves it
/// with uniform acceleration. The course always stays within the motor's step. The error is at most
/// half a step at a pause and one step at a reversal, and usually a small part of that.
class EdgeTrack {
 public:
  /// Begins a track.
  /// @param window_s least duration of motions that must be resolved
  /// @param start position before the first edge
  EdgeTrack(double window_s, double start) : window_s_{window_s}, start_{start} {}

  /// Greatest duration of the half step to a rest, in windows. If an axis takes longer, it counts
  /// as paused. Its acceleration is at most step / (16 windows)².
  static constexpr double kLongestSettling = 16.0;

  /// Returns the age up to which a new edge may still change the course, s.
  [[nodiscard]] double lag_s() const { return 6.0 * kLongestSettling * window_s_; }

  /// Adds an edge.
  /// @pre times increase
  void add(const AxisEdge& edge);

  /// Returns the course at a time that is at least lag_s() before every later edge. Drops edges
  /// that no later call requires.
  /// @pre times never decrease
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
  /// The kept edges. At most three of them are before the time of the last query.
  std::deque<AxisEdge> edges_;
};

}  // namespace sim
