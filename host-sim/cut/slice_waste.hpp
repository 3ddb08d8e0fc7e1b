#pragma once

#include <optional>

#include "host-sim/cut/loop_area.hpp"
#include "host-sim/cut/plan.hpp"

namespace sim::cut {

/// Settings for cutting up the waste.
struct SliceRules {
  /// Greatest width and height of a piece of waste, above 0.
  double piece_mm = 500.0;
  double margin_mm = 5.0;  ///< Margin of the sheet around all cuts, 0 or more.
  /// The sheet, if it is known; then the margin does not apply.
  std::optional<LoopArea::Box> stock{};
};

/// Appends cuts that divide the rest of the sheet around the parts into pieces, so that it can be
/// carried away. They are straight lines across the sheet, the vertical ones first. They omit
/// everything inside a contour or nearer to a drawn line than a kerf, so they end in the slot of
/// the part. Their power and feed are those of the last cut at an offset from a line, or else of
/// the last cut. If the sheet is not known, it is the box of all cuts plus the margin. If all cuts
/// are on the positive side of zero, it does not extend beyond zero. Counts in `safety`.
void slice_waste(CutPlan& plan, const drawing::Drawing& drawn, const SliceRules& rules);

}  // namespace sim::cut
