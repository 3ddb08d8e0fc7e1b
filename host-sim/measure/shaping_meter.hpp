#pragma once

#include <deque>

#include "host-sim/measure/curve.hpp"
#include "planner/motion/motors/motor_stage.hpp"

namespace sim {

/// How far input shaping takes the tool from its planned path: the greatest distance of
/// a shaped place from the planned places within reach of the shapers, cell by cell.
///
/// Between the ends of cells, at most 1 ms, the path counts as straight; on an arc at
/// acceleration a that is short of it by a (1 ms)² / 8. Neither steps nor backlash are in it.
class ShapingMeter final : public cnc::motion::ShapingObserver {
 public:
  /// @param steps_per_mm of degrees for A, B and C
  explicit ShapingMeter(const cnc::AxisArray<double>& steps_per_mm) : steps_per_mm_{steps_per_mm} {}

  void on_cell(const cnc::motion::ShapedCell& cell) override;

  /// mm.
  [[nodiscard]] double greatest_distance() const { return greatest_; }

 private:
  [[nodiscard]] Point to_mm(const cnc::AxisArray<cnc::StepPosition>& places) const;

  cnc::AxisArray<double> steps_per_mm_;
  std::deque<Point> planned_;  ///< The newest first.
  double greatest_ = 0.0;
};

}  // namespace sim
