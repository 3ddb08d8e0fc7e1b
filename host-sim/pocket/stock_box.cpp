#include "host-sim/pocket/stock_box.hpp"

#include <algorithm>
#include <cmath>

namespace sim::pocket {

double gap_to(const StockBox& stock, const cnc::WideVec2& place) {
  const double dx = std::max({stock.x0 - place.x(), 0.0, place.x() - stock.x1});
  const double dy = std::max({stock.y0 - place.y(), 0.0, place.y() - stock.y1});
  return std::hypot(dx, dy);
}

bool is_beside(const StockBox& stock, const cnc::WideVec2& centre, double radius_mm) {
  constexpr double kRoundingMm = 1.0e-9;
  return gap_to(stock, centre) >= radius_mm + kRoundingMm;
}

bool is_idle(const StockBox& stock, const cnc::WideVec2& centre, double radius_mm) {
  return gap_to(stock, centre) >= radius_mm - 2.0 * kStockSkinMm;
}

}  // namespace sim::pocket
