#pragma once

#include "planner/contour/curve.hpp"
#include "planner/geometry/vector.hpp"

namespace sim::pocket {

/// The outline of the stock as seen from above, a rectangle along the axes, mm.
using StockBox = cnc::contour::FlatBox<double>;

/// Thickness of the skin that does not count as stock on all sides, mm. Therefore walls that are
/// drawn on the edge of the stock end outside of it.
inline constexpr double kStockSkinMm = 1.0e-3;

[[nodiscard]] inline StockBox widened(const StockBox& box, double by_mm) {
  return {box.x0 - by_mm, box.y0 - by_mm, box.x1 + by_mm, box.y1 + by_mm};
}

/// Returns the distance from a point to the stock, mm; 0 inside the stock.
[[nodiscard]] double gap_to(const StockBox& stock, const cnc::WideVec2& place);

/// Returns whether a disc is next to the stock and touches neither the stock nor its skin.
[[nodiscard]] bool is_beside(const StockBox& stock, const cnc::WideVec2& centre, double radius_mm);

/// Returns whether a disc touches no part of the stock except its skin.
[[nodiscard]] bool is_idle(const StockBox& stock, const cnc::WideVec2& centre, double radius_mm);

}  // namespace sim::pocket
