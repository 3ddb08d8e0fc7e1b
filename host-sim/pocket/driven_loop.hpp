#pragma once

#include <vector>

#include "host-sim/contour/contour_offset.hpp"
#include "host-sim/cut/stroke.hpp"
#include "planner/pocket/loop_place.hpp"

namespace sim::pocket {

/// Returns a row of strokes that is driven from the end of `row` to its start.
[[nodiscard]] std::vector<cut::Stroke> reversed(std::vector<cut::Stroke> row);

/// A loop in its direction of driving, with distances along the loop, mm. An arc of more than half
/// a turn becomes two strokes.
class DrivenLoop {
 public:
  DrivenLoop(const cnc::contour::ContourView<double>& contour,
             std::size_t loop,
             cnc::pocket::Milling milling);

  [[nodiscard]] double length() const { return row_.length(); }
  [[nodiscard]] const cut::MeasuredRow& row() const { return row_; }
  /// Returns the distance along the loop from its start to the point nearest to `place`, mm.
  [[nodiscard]] double way_at(const cnc::WideVec2& place) const;
  /// Returns the strokes between two distances along the loop. The strokes lead across the start of
  /// the loop if `to_mm` is not greater than `from_mm`. If both distances are equal, the result is
  /// a full revolution around the loop.
  [[nodiscard]] std::vector<cut::Stroke> stretch(double from_mm, double to_mm) const;
  /// Returns the distance along the loop to the middle of its longest stroke, mm.
  [[nodiscard]] double longest_middle() const;

 private:
  cut::MeasuredRow row_;
};

}  // namespace sim::pocket
