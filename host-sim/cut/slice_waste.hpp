#pragma once

#include <optional>

#include "host-sim/cut/loop_area.hpp"
#include "host-sim/cut/plan.hpp"

namespace sim::cut {

/// How the waste is cut up.
struct SliceRules {
  double piece_mm = 500.0;               ///< No piece of waste is wider or higher, above 0.
  double margin_mm = 5.0;                ///< Of the sheet around all that is cut, 0 or more.
  std::optional<LoopArea::Box> stock{};  ///< The sheet, where it is known; then without margin.
};

/// Appends cuts that make pieces of what remains of the sheet round the parts, so that it can be
/// carried away: straight lines across the sheet, the upright ones first, without what is inside of
/// a contour or nearer to a drawn line than a kerf. There they end in the slot of the part. They
/// have power and feed of the last cut beside a line. Without a sheet, it is the box of all that is
/// cut, with the margin, though not beyond zero where all else is on this side of it. Counts in
/// `safety`.
void slice_waste(CutPlan& plan, const drawing::Drawing& drawn, const SliceRules& rules);

}  // namespace sim::cut
