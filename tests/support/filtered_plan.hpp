#pragma once

#include <cstddef>
#include <vector>

namespace sim {

/// A stretch of constant acceleration of a plan, place over time along the path.
struct PlanPiece {
  double duration = 0.0;      ///< s.
  double place = 0.0;         ///< mm from the start of the path, at its start.
  double speed = 0.0;         ///< mm/s, at its start.
  double acceleration = 0.0;  ///< mm/s².

  [[nodiscard]] double place_after(double time) const {
    return place + (speed + 0.5 * acceleration * time) * time;
  }
  [[nodiscard]] double speed_after(double time) const { return speed + acceleration * time; }
  /// ∫ (place − `from`) dt over the first `time` seconds, mm s.
  [[nodiscard]] double place_integral(double time, double from) const {
    return (place - from + (0.5 * speed + acceleration * time / 6.0) * time) * time;
  }
};

/// The motion along the path at one moment.
struct PathState {
  double place = 0.0;         ///< mm.
  double speed = 0.0;         ///< mm/s.
  double acceleration = 0.0;  ///< mm/s².
  double jerk = 0.0;          ///< mm/s³, of the stretch that begins here.
};

/// The mean of a plan s0(t) over the last `window` seconds:
///   s(t) = 1/T ∫ s0(u) du, u = t − T … t.
/// Its derivatives are differences: v = (s0(t) − s0(t − T)) / T, and so on. s is a
/// cubic between two breakpoints. Before its start and after its end the plan stands.
///
/// Evaluated in closed form over the pieces that the window holds: exact but for
/// rounding, 1e-15 of the place.
class FilteredPlan {
 public:
  /// Pieces follow each other; each names its own place and speed, so that errors of a
  /// plan do not add up here (gaps are found by greatest_gap). @pre window > 0, pieces not empty
  FilteredPlan(std::vector<PlanPiece> pieces, double window);

  /// Quick for a time near the one asked for last.
  [[nodiscard]] PathState at(double time) const;

  /// The length of the motion: the plan and the window.
  [[nodiscard]] double seconds() const { return starts_.back() + window_; }
  [[nodiscard]] double window() const { return window_; }

  /// All times at which the jerk may change, in order, from 0 to seconds().
  [[nodiscard]] std::vector<double> breakpoints() const;

  /// The greatest mismatch from one piece to the next, mm and mm/s.
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

  std::vector<PlanPiece> pieces_;  ///< With a rest before and one after.
  std::vector<double> starts_;     ///< s; the rest before starts at −∞.
  double window_;
  mutable std::size_t oldest_ = 0;  ///< Where the window was last.
  mutable std::size_t newest_ = 0;
};

}  // namespace sim
