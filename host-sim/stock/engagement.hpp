#pragma once

#include "host-sim/stock/carver.hpp"
#include "host-sim/stock/stock.hpp"

namespace sim::stock {

/// Bounds of the angle, in degrees, over which the circumference of a flat tool touches stock at
/// the depth of its tip. The bounds differ where cells are partly cut.
struct Engagement {
  double min_deg = 0.0;
  double max_deg = 0.0;

  [[nodiscard]] double middle_deg() const { return 0.5 * (min_deg + max_deg); }
};

/// Returns the greatest engagement of a flat tool along a stretch, measured on the stock before the
/// stretch is cut. Only the leading half of the circumference is considered, because the other half
/// is in the tool's own cut. Checks poses at distances of at most an eighth of the radius,
/// beginning at the start. Stock that rises above the tip by less than 2 µm plus twice the
/// stretch's slack in height counts as floor, not as engaged. A vertical stretch has no engagement.
[[nodiscard]] Engagement greatest_engagement(const Stock& stock,
                                             double radius_mm,
                                             const Stretch& stretch);

}  // namespace sim::stock
