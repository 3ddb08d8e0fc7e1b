#pragma once

#include <string>
#include <vector>

#include "host-sim/cut/plan.hpp"
#include "host-sim/cut/price.hpp"
#include "host-sim/cut/timeline.hpp"

namespace sim::cut {

/// Copies of one part: an outer contour that is cut beside its line, with the holes and marks in
/// it. A part that lies in a hole of another one is a part of its own.
struct PartRow {
  std::string name{};  ///< Of the outer contour of the first copy; of the last row `on the sheet`.
  std::size_t copies = 0;
  std::size_t number = 0;      ///< Of the last cut of the first copy, as in pictures: from 1.
  std::size_t pierces = 0;     ///< Of all copies, as everything below.
  double cut_length_mm = 0.0;  ///< With leads, without tabs.
  double area_mm2 = 0.0;       ///< Of the material that is left: holes are subtracted.
  double time_s = 0.0;  ///< Of its cuts and the rapids to them, with its share of the way back.
  Cost cost{};
};

/// Returns a row for each part that is cut, in the order in which their first copies are finished,
/// and a last one for cuts that belong to no part, where there are such. Parts whose outer contours
/// and holes have the same areas and lengths are copies. Times add up to the timeline's; the price
/// of the sheet is shared by area, or evenly where nothing has one.
[[nodiscard]] std::vector<PartRow> part_table(const drawing::Drawing& drawn,
                                              const CutPlan& plan,
                                              const Timeline& timeline,
                                              const PriceList& prices);

}  // namespace sim::cut
