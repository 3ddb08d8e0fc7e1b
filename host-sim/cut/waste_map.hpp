#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "host-sim/cut/clearance.hpp"
#include "host-sim/cut/plan.hpp"

namespace sim::cut {

/// How near a straight way comes to the lines of a drawing that are cut, and to tabs.
class WasteMap {
 public:
  /// @param reach_mm nothing farther is measured, above 0
  WasteMap(const CutPlan& plan, const drawing::Drawing& drawn, double reach_mm);

  /// Distance to the nearest line that is cut, at most the reach, mm.
  [[nodiscard]] double distance_to_lines(const Place& place) const;

  /// Returns whether a straight way keeps these distances; shallower intrusions than a micrometre
  /// may be missed. @pre both are less than the reach
  [[nodiscard]] bool is_clear(const Place& from,
                              const Place& to,
                              double from_lines_mm,
                              double from_tabs_mm) const;

  /// Returns the stretches of a straight way that are no nearer to lines than this, as lengths from
  /// its start; their ends are within a micrometre of where they could be.
  [[nodiscard]] std::vector<std::pair<double, double>> clear_stretches(const Place& from,
                                                                       const Place& to,
                                                                       double from_lines_mm) const;

 private:
  Clearance lines_;
  Clearance tabs_;
};

}  // namespace sim::cut
