#pragma once

#include <cstdint>
#include <vector>

#include "host-sim/measure/course_meter.hpp"
#include "host-sim/measure/difference_meter.hpp"
#include "host-sim/trace/trace_row.hpp"

namespace sim {

/// Windows over which the measures average, s. A measure cannot show motions shorter than its
/// window. With a short window, errors of the edges' times appear as noise (DifferenceMeter). Jerk
/// has the most noise, so its window is the longest.
struct MeterWindows {
  double speed_s = 0.010;
  double acceleration_s = 0.010;
  double jerk_s = 0.020;
  double course_s = 0.010;  ///< Window of the measures along the path (CourseMeter).
};

/// Motion of one axis, in mm and seconds; in degrees and seconds for A, B and C.
struct AxisMotion {
  double greatest_speed = 0.0;
  double greatest_acceleration = 0.0;
  double greatest_jerk = 0.0;
  double lowest = 0.0;  ///< Least position of the motor.
  double highest = 0.0;
  std::uint64_t steps = 0;
};

/// Measures the motion from the pulses, row by row, in bounded memory.
///
/// The pulses prove the values of one axis: the true values are at least as great, except for
/// errors of the edges' times (DifferenceMeter). The values along the path are estimates, because
/// no two axes step at the same instant (CourseMeter). All values are complete after on_end().
class MotionMeter final : public TraceSink {
 public:
  /// Begins the measurement.
  /// @param steps_per_mm steps per mm; steps per degree for A, B and C
  /// @pre the motors are at step 0 before the first row
  explicit MotionMeter(const cnc::AxisArray<double>& steps_per_mm,
                       const MeterWindows& windows = {});

  void on_row(const TraceRow& row) override;
  /// Ends the measurement. The motors count as at rest after their last edges, whatever `time_ns`
  /// is.
  void on_end(std::uint64_t time_ns) override;

  [[nodiscard]] AxisMotion axis(cnc::Axis which) const;
  /// Returns the greatest speed along X Y Z together, mm/s.
  [[nodiscard]] double greatest_path_speed() const { return course_.greatest_speed(); }
  /// Returns the greatest norm of the acceleration of X Y Z, mm/s². On a circle at constant speed,
  /// this norm is v²/R.
  [[nodiscard]] double greatest_path_acceleration() const {
    return course_.greatest_acceleration();
  }
  [[nodiscard]] double path_length() const { return course_.length(); }

 private:
  struct AxisMeter {
    double step = 0.0;
    DifferenceMeter speed;
    DifferenceMeter acceleration;
    DifferenceMeter jerk;
    std::int32_t lowest = 0;
    std::int32_t highest = 0;
    std::uint64_t steps = 0;
  };

  void add_edge(std::size_t axis, double time_s, std::int32_t from, std::int32_t to);

  std::vector<AxisMeter> axes_;
  CourseMeter course_;
  cnc::AxisArray<std::int32_t> position_{};
};

}  // namespace sim
