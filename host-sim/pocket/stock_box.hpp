#pragma once

#include "planner/contour/curve.hpp"
#include "planner/geometry/vector.hpp"

namespace sim::pocket {

/// The outline of the stock in plan, a rectangle along the axes, mm.
using StockBox = cnc::contour::FlatBox<double>;

/// The stock counts as smaller by this on all sides, mm, so that walls drawn on its edge end beyond
/// it.
inline constexpr double kStockSkinMm = 1.0e-3;

[[nodiscard]] inline StockBox widened(const StockBox& box, double by_mm) {
  return {box.x0 - by_mm, box.y0 - by_mm, box.x1 + by_mm, box.y1 + by_mm};
}

/// Returns how far a place is beside the stock, mm; 0 in the stock.
[[nodiscard]] double gap_to(const StockBox& stock, const cnc::WideVec2& place);

/// Returns whether a disc beside the stock meets none of it, nor its skin.
[[nodiscard]] bool is_beside(const StockBox& stock, const cnc::WideVec2& centre, double radius_mm);

/// Returns whether a disc meets nothing of the stock but its skin.
[[nodiscard]] bool is_idle(const StockBox& stock, const cnc::WideVec2& centre, double radius_mm);

}  // namespace sim::pocket
