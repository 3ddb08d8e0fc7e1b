#pragma once

#include <cstddef>
#include <vector>

namespace sim {

/// A stretch of a plan with constant acceleration: position along the path over time.
struct PlanPiece {
  double duration = 0.0;      ///< Duration, s.
  double place = 0.0;         ///< Position along the path at the start of the piece, mm.
  double speed = 0.0;         ///< Speed at the start of the piece, mm/s.
  double acceleration = 0.0;  ///< Acceleration, mm/s².

  [[nodiscard]] double place_after(double time) const {
    return place + (speed + 0.5 * acceleration * time) * time;
  }
  [[nodiscard]] double speed_after(double time) const { return speed + acceleration * time; }
  /// Returns ∫ (position − `from`) dt over the first `time` seconds, mm s.
  [[nodiscard]] double place_integral(double time, double from) const {
    return (place - from + (0.5 * speed + acceleration * time / 6.0) * time) * time;
  }
};

/// The motion along the path at one time.
struct PathState {
  double place = 0.0;         ///< Position along the path, mm.
  double speed = 0.0;         ///< Speed, mm/s.
  double acceleration = 0.0;  ///< Acceleration, mm/s².
  double jerk = 0.0;          ///< Jerk of the stretch that begins here, mm/s³.
};

/// The mean of a plan s0(t) over the last `window` seconds: s(t) = 1/T ∫ s0(u) du, u = t − T … t.
/// Its derivatives are differences: v = (s0(t) − s0(t − T)) / T, and so on. Between two
/// breakpoints, s is a cubic. Before its start and after its end the plan is at rest.
///
/// The mean is computed in closed form over the pieces in the window: exact except for rounding.
class FilteredPlan {
 public:
  /// Takes the pieces of a plan in order. Each piece has its own position and speed, so that a
  /// plan's rounding errors do not accumulate here; greatest_gap() reports them. @pre window > 0,
  /// pieces not empty
  FilteredPlan(std::vector<PlanPiece> pieces, double window);

  /// Returns the motion at a time. Fast if the time is close to that of the previous call.
  [[nodiscard]] PathState at(double time) const;

  /// Returns the duration of the motion, s: that of the plan and one window.
  [[nodiscard]] double seconds() const { return starts_.back() + window_; }
  [[nodiscard]] double window() const { return window_; }

  /// Returns all times at which the jerk may change, in order, from 0 to seconds().
  [[nodiscard]] std::vector<double> breakpoints() const;

  /// Greatest difference between the end of a piece and the start of the next: position in mm,
  /// speed in mm/s.
  struct Gap {
    double place = 0.0;
    double speed = 0.0;
  };
  [[nodiscard]] Gap greatest_gap() const;

 private:
  struct Moment {
    double place = 0.0;
    double speed = 0.0;
    double acceleration = 0.0;
  };
  [[nodiscard]] std::size_t piece_at(double time, std::size_t guess) const;
  [[nodiscard]] Moment moment(double time, std::size_t piece) const;
  [[nodiscard]] double mean_place(double time, std::size_t first, std::size_t last) const;

  std::vector<PlanPiece> pieces_;  ///< The pieces, with a rest before them and a rest after them.
  std::vector<double> starts_;     ///< Start times, s; the rest at the beginning starts at −∞.
  double window_;
  /// First piece in the window at the last call; `newest_` is the last one.
  mutable std::size_t oldest_ = 0;
  mutable std::size_t newest_ = 0;
};

}  // namespace sim
