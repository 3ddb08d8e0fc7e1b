#pragma once

#include <vector>

#include "host-sim/contour/contour_offset.hpp"
#include "host-sim/cut/stroke.hpp"
#include "planner/pocket/loop_place.hpp"

namespace sim::pocket {

/// Returns a row of strokes from its end to its start.
[[nodiscard]] std::vector<cut::Stroke> reversed(std::vector<cut::Stroke> row);

/// A loop in the direction in which it is driven, with ways along it, mm. Arcs of more than half a
/// turn are two strokes.
class DrivenLoop {
 public:
  DrivenLoop(const cnc::contour::ContourView<double>& contour,
             std::size_t loop,
             cnc::pocket::Milling milling);

  [[nodiscard]] double length() const { return row_.length(); }
  [[nodiscard]] const cut::MeasuredRow& row() const { return row_; }
  /// Returns the way from the first place of the loop to the one that is nearest to a place.
  [[nodiscard]] double way_at(const cnc::WideVec2& place) const;
  /// Returns what lies between two ways, around the first place of the loop where the second is not
  /// after the first one: all of the loop where both are the same.
  [[nodiscard]] std::vector<cut::Stroke> stretch(double from_mm, double to_mm) const;
  /// Returns the way to the middle of the longest stroke.
  [[nodiscard]] double longest_middle() const;

 private:
  cut::MeasuredRow row_;
};

}  // namespace sim::pocket
