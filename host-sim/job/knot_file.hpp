#pragma once

#include <cstdint>
#include <string>

#include "host-sim/measure/curve.hpp"
#include "host-sim/trace/output_file.hpp"
#include "planner/motion/motors/motor_stage.hpp"

namespace sim {

/// Writes the places of the axes that the plan goes through where cells of time divide it, as under
/// G43.4: a line `time_s x y z a b c` for each below a heading, mm and degrees with 17 digits. Time
/// is that of the motions; rests between them do not count.
class KnotFile final : public cnc::motion::ShapingObserver {
 public:
  /// @param next is told the same; it outlives this
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
