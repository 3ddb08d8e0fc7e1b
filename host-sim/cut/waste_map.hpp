#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "host-sim/cut/clearance.hpp"
#include "host-sim/cut/plan.hpp"

namespace sim::cut {

/// Measures distances of straight paths from the lines of a drawing that are cut, and from tabs.
class WasteMap {
 public:
  /// Makes a map of the lines and tabs of a plan.
  /// @param reach_mm greatest distance that is measured, above 0
  WasteMap(const CutPlan& plan, const drawing::Drawing& drawn, double reach_mm);

  /// Returns the distance of a point from the nearest line that is cut, mm, at most the reach.
  [[nodiscard]] double distance_to_lines(const Place& place) const;

  /// Returns whether a straight path keeps both given distances from lines and tabs. Intrusions
  /// shallower than a micrometre may be missed.
  /// @pre both distances are below the reach
  [[nodiscard]] bool is_clear(const Place& from,
                              const Place& to,
                              double from_lines_mm,
                              double from_tabs_mm) const;

  /// Returns the stretches of a straight path that keep `from_lines_mm` from lines. Each pair has
  /// the distances from the start of the path to both ends of a stretch, accurate to a micrometre.
  [[nodiscard]] std::vector<std::pair<double, double>> clear_stretches(const Place& from,
                                                                       const Place& to,
                                                                       double from_lines_mm) const;

 private:
  Clearance lines_;
  Clearance tabs_;
};

}  // namespace sim::cut
