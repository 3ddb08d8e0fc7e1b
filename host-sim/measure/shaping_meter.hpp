#pragma once

#include <deque>

#include "host-sim/measure/curve.hpp"
#include "planner/motion/motors/motor_stage.hpp"

namespace sim {

/// Measures the greatest distance by which input shaping takes the tool from its planned path. In
/// each cell, this is the distance of the shaped position from the planned positions within the
/// reach of the shapers.
///
/// Between the ends of cells, which are at most 1 ms apart, the planned path counts as straight. On
/// an arc with an acceleration a, the straight line is off by a (1 ms)² / 8. The measure includes
/// neither steps nor backlash.
class ShapingMeter final : public cnc::motion::ShapingObserver {
 public:
  /// Begins the measurement.
  /// @param steps_per_mm steps per mm; steps per degree for A, B and C
  explicit ShapingMeter(const cnc::AxisArray<double>& steps_per_mm) : steps_per_mm_{steps_per_mm} {}

  void on_cell(const cnc::motion::ShapedCell& cell) override;

  /// Returns the greatest distance of all cells, mm.
  [[nodiscard]] double greatest_distance() const { return greatest_; }

 private:
  [[nodiscard]] Point to_mm(const cnc::AxisArray<cnc::StepPosition>& places) const;

  cnc::AxisArray<double> steps_per_mm_;
  std::deque<Point> planned_;  ///< Planned positions, the newest first.
  double greatest_ = 0.0;
};

}  // namespace sim
