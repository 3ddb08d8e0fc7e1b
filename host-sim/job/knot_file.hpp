#pragma once

#include <cstdint>
#include <string>

#include "host-sim/measure/curve.hpp"
#include "host-sim/trace/output_file.hpp"
#include "planner/motion/motors/motor_stage.hpp"

namespace sim {

/// Writes the positions of the axes at the ends of the cells of time into which a plan is divided,
/// for example under G43.4. After a heading, each position is a line `time_s x y z a b c`, in mm
/// and degrees, with 17 digits. The time does not include the rests between motions.
class KnotFile final : public cnc::motion::ShapingObserver {
 public:
  /// Creates the file.
  /// @param next observer to which the same cells are passed on; it must outlive this object
  KnotFile(const std::string& file,
           const cnc::AxisArray<double>& steps_per_mm,
           cnc::motion::ShapingObserver& next);

  void on_cell(const cnc::motion::ShapedCell& cell) override;
  void close() { file_.close(); }

  /// Returns whether no position was written.
  [[nodiscard]] bool is_empty() const { return time_ns_ == 0; }

 private:
  cnc::AxisArray<double> steps_per_mm_;
  cnc::motion::ShapingObserver& next_;
  OutputFile file_;
  std::uint64_t time_ns_ = 0;
};

}  // namespace sim
