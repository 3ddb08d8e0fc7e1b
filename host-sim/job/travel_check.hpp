#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "firmware/machine/settings.hpp"
#include "host-sim/measure/programmed_path.hpp"
#include "host-sim/report/report.hpp"

namespace sim {

/// Which axes need more travel than they have ($130…$135; 0 is endless).
///
/// Where a job starts within the machine is known only at the machine, so what
/// counts is the extent of the motion: a job that is no larger than the travel
/// fits somewhere. One fault an axis, at the line that first goes too far, with
/// the column of the axis word where there is one.
class TravelCheck {
 public:
  explicit TravelCheck(const cnc::Settings& settings);

  void put(const PathPiece& piece);
  [[nodiscard]] const Bounds& bounds() const { return bounds_; }
  /// @param file its name @param text the program itself, for the columns
  [[nodiscard]] std::vector<Fault> faults(const std::string& file, std::string_view text) const;

 private:
  cnc::AxisArray<double> travel_{};
  Bounds bounds_{};                      ///< With the start, which is zero.
  cnc::AxisArray<int> first_overrun_{};  ///< Its line; 0 for none.
};

}  // namespace sim
