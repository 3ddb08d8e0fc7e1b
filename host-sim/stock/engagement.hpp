#pragma once

#include "host-sim/stock/carver.hpp"
#include "host-sim/stock/stock.hpp"

namespace sim::stock {

/// Bounds of the angle, in degrees, over which the circumference of a flat tool touches stock at
/// the depth of its tip. Cells that are cut in part are between them.
struct Engagement {
  double least_deg = 0.0;
  double most_deg = 0.0;

  [[nodiscard]] double middle_deg() const { return 0.5 * (least_deg + most_deg); }
};

/// The greatest engagement of a flat tool along a stretch, measured on the stock before it: of the
/// half of the circumference that goes ahead, because the other half follows in its own cut.
/// Poses are an eighth of the radius apart, the first at the start. Stock that is less than 2 µm,
/// and twice the stretch's slack in height, above the tip is taken for a floor that is cut.
/// Nothing of a stretch that goes straight up or down.
[[nodiscard]] Engagement greatest_engagement(const Stock& stock,
                                             double radius_mm,
                                             const Stretch& stretch);

}  // namespace sim::stock
