#pragma once

#include <optional>

#include "host-sim/cut/loop_area.hpp"
#include "host-sim/cut/plan.hpp"

namespace sim::cut {

/// Settings for dividing the waste into pieces.
struct SliceRules {
  /// Greatest width and height of a piece of waste, above 0.
  double piece_mm = 500.0;
  double margin_mm = 5.0;  ///< Margin that the sheet has around all cuts, 0 or more.
  /// The sheet, if it is known. The margin is then not used.
  std::optional<LoopArea::Box> stock{};
};

/// Appends cuts that divide the rest of the sheet around the parts into pieces that can be carried
/// away. The cuts are straight lines across the sheet, the vertical ones first. They leave out
/// points inside a contour, and points nearer to a drawn line than a kerf, so they end in the kerf
/// around the part. They have the power and feed of the last cut at an offset from its line, or if
/// there is none, of the last cut. If the sheet is not known, it is the box of all cuts plus the
/// margin. If no cut has a negative X (or Y), this box does not extend below zero there. Counts the
/// cuts in `safety`.
void slice_waste(CutPlan& plan, const drawing::Drawing& drawn, const SliceRules& rules);

}  // namespace sim::cut
