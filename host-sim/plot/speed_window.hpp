#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>

namespace sim {

/// Measures the speed of stepping motors over a stretch of a few milliseconds.
///
/// Steps of several axes interleave, so the intervals between single steps contain little
/// information. Therefore the length is the sum of chords of at least `kChordSteps` steps. With
/// these chords the error of the staircase is of second order (below 1 %), and they still follow a
/// curve.
class SpeedWindow {
 public:
  struct Point {
    double x_mm;
    double y_mm;
    double z_mm;
  };

  /// Time without a step after which the machine counts as at rest. Such a pause must not be
  /// averaged into the motion before and after it.
  static constexpr std::uint64_t kStandstillNs = 50'000'000;

  /// @param step_mm length of the longer of the steps of X and Y
  explicit SpeedWindow(double step_mm)
      : chord_mm_{kChordSteps * step_mm}, long_enough_mm_{kWindowSteps * step_mm} {}

  void restart(std::uint64_t time_ns, const Point& at) {
    start_ns_ = last_ns_ = time_ns;
    chord_start_ = last_ = at;
    length_mm_ = 0.0;
  }

  void move_to(std::uint64_t time_ns, const Point& to) {
    last_ns_ = time_ns;
    last_ = to;
    const double chord_mm = distance_mm(chord_start_, to);
    if (chord_mm < chord_mm_) return;
    length_mm_ += chord_mm;
    chord_start_ = to;
  }

  /// Returns whether the window is long enough, in time and in steps, for a useful speed.
  [[nodiscard]] bool is_full() const {
    return last_ns_ - start_ns_ >= kWindowNs && length_mm_ >= long_enough_mm_;
  }

  /// Returns the mean speed since restart(); `otherwise` if the steps are too few and the time is
  /// too short for a measurement.
  [[nodiscard]] double speed_mm_s(double otherwise) const {
    const std::uint64_t elapsed_ns = last_ns_ - start_ns_;
    const double length_mm = length_mm_ + distance_mm(chord_start_, last_);
    if (length_mm < chord_mm_ && elapsed_ns < kStandstillNs) return otherwise;
    return length_mm / (1e-9 * static_cast<double>(elapsed_ns));
  }

  [[nodiscard]] std::uint64_t last_ns() const { return last_ns_; }
  [[nodiscard]] const Point& last() const { return last_; }

 private:
  static constexpr double kChordSteps = 8.0;
  /// Least length of a window, in steps. The direction of the path is then known to about 3 %.
  static constexpr double kWindowSteps = 32.0;
  /// Least duration of a window: the time for 0.5 mm at 100 mm/s.
  static constexpr std::uint64_t kWindowNs = 5'000'000;

  [[nodiscard]] static double distance_mm(const Point& a, const Point& b) {
    return std::hypot(b.x_mm - a.x_mm, b.y_mm - a.y_mm, b.z_mm - a.z_mm);
  }

  double chord_mm_;
  double long_enough_mm_;
  std::uint64_t start_ns_ = 0;
  std::uint64_t last_ns_ = 0;
  Point chord_start_{};
  Point last_{};
  double length_mm_ = 0.0;
};

}  // namespace sim
