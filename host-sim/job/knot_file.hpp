#pragma once

#include <cstdint>
#include <string>

#include "host-sim/measure/curve.hpp"
#include "host-sim/trace/output_file.hpp"
#include "planner/motion/motors/motor_stage.hpp"

namespace sim {

/// Writes the positions of the axes at which cells of time divide the plan, as under G43.4. Below a
/// heading, each position is one line `time_s x y z a b c`, in mm and degrees with 17 digits. The
/// time is that of the motions; rests between them do not count.
class KnotFile final : public cnc::motion::ShapingObserver {
 public:
  /// Creates the file.
  /// @param next gets the same cells; it must outlive this object
  KnotFile(const std::string& file,
           const cnc::AxisArray<double>& steps_per_mm,
           cnc::motion::ShapingObserver& next);

  void on_cell(const cnc::motion::ShapedCell& cell) override;
  void close() { file_.close(); }

  /// Returns whether no cell was written.
  [[nodiscard]] bool is_empty() const { return time_ns_ == 0; }

 private:
  cnc::AxisArray<double> steps_per_mm_;
  cnc::motion::ShapingObserver& next_;
  OutputFile file_;
  std::uint64_t time_ns_ = 0;
};

}  // namespace sim
