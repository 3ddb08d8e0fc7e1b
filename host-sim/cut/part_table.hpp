#pragma once

#include <string>
#include <vector>

#include "host-sim/cut/plan.hpp"
#include "host-sim/cut/price.hpp"
#include "host-sim/cut/timeline.hpp"

namespace sim::cut {

/// Figures of a part over all its copies. A part is an outer contour that is cut at an offset, with
/// the holes and marks inside it. A part inside a hole of another part is a separate part.
struct PartRow {
  /// Name of the outer contour of the first copy; `on the sheet` in the last row.
  std::string name{};
  std::size_t copies = 0;
  /// Number of the last cut of the first copy, counted from 1, as pictures show it.
  std::size_t number = 0;
  /// Number of pierces of all copies. All members below are sums over all copies, too.
  std::size_t pierces = 0;
  double cut_length_mm = 0.0;  ///< Length of the cuts, including leads, without tabs.
  double area_mm2 = 0.0;       ///< Area of the material of the parts, without holes.
  /// Time of the cuts and of the rapids to them, with a share of the last rapid of the job.
  double time_s = 0.0;
  Cost cost{};
};

/// Returns a row for each part that is cut, in the order in which the first copies are finished. If
/// some cuts belong to no part, a last row contains them. Parts are copies if their contours have
/// the same layers, areas and lengths, rounded. Times add up to the timeline's total. The price of
/// the sheet is shared by area, or evenly if no row has an area.
[[nodiscard]] std::vector<PartRow> part_table(const drawing::Drawing& drawn,
                                              const CutPlan& plan,
                                              const Timeline& timeline,
                                              const PriceList& prices);

}  // namespace sim::cut
