#include "host-sim/stock/plan_region.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace sim::stock {
namespace {

/// Calls `take(from, to)` with the ends of each straight piece of a ring.
template <typename Take>
void each_piece(const Ring& ring, Take take) {
  for (std::size_t i = 0; i < ring.size(); ++i) take(ring[i], ring[(i + 1) % ring.size()]);
}

}  // namespace

PlanRegion::PlanRegion(const std::vector<Ring>& rings, const Stock& stock) : stock_{stock} {
  fit_to(rings);
  parts_.assign(grid_.size(), RegionPart::kOutside);
  for (int row = 0; row < grid_.rows; ++row) fill_row(rings, row);
  for (const Ring& ring : rings) {
    each_piece(ring, [this](const auto& from, const auto& to) { mark_edge(from, to); });
  }
}

/// Sets the grid to the bounding box of the rings, extended by one cell on each side.
void PlanRegion::fit_to(const std::vector<Ring>& rings) {
  constexpr double kFar = std::numeric_limits<double>::infinity();
  std::array<double, 2> low{kFar, kFar};
  std::array<double, 2> high{-kFar, -kFar};
  for (const Ring& ring : rings) {
    for (const auto& point : ring) {
      for (std::size_t axis = 0; axis < 2; ++axis) {
        low[axis] = std::min(low[axis], point[axis]);
        high[axis] = std::max(high[axis], point[axis]);
      }
    }
  }
  grid_ = {0, 0, stock_.cell_x_mm(), stock_.cell_y_mm()};
  if (low[0] > high[0]) return;
  const auto cell = [](double place, double begin, double size) {
    return static_cast<int>(std::floor((place - begin) / size));
  };
  const StockBox& box = stock_.box();
  first_column_ = cell(low[0], box.x_min, grid_.cell_x_mm) - 1;
  first_row_ = cell(low[1], box.y_min, grid_.cell_y_mm) - 1;
  grid_.columns = cell(high[0], box.x_min, grid_.cell_x_mm) + 2 - first_column_;
  grid_.rows = cell(high[1], box.y_min, grid_.cell_y_mm) + 2 - first_row_;
}

/// Marks the cells of a row whose centres are inside. These centres are between the first and the
/// second crossing of the row with the rings, between the third and the fourth, and so on.
void PlanRegion::fill_row(const std::vector<Ring>& rings, int row) {
  const double y = stock_.box().y_min + (first_row_ + row + 0.5) * grid_.cell_y_mm;
  std::vector<double> crossings;
  for (const Ring& ring : rings) {
    each_piece(ring, [&](const auto& from, const auto& to) {
      if ((from[1] <= y) == (to[1] <= y)) return;
      crossings.push_back(from[0] + (y - from[1]) / (to[1] - from[1]) * (to[0] - from[0]));
    });
  }
  std::ranges::sort(crossings);
  const double left = stock_.box().x_min + (first_column_ + 0.5) * grid_.cell_x_mm;
  for (std::size_t i = 0; i + 1 < crossings.size(); i += 2) {
    const int first = static_cast<int>(std::ceil((crossings[i] - left) / grid_.cell_x_mm));
    const int last = static_cast<int>(std::floor((crossings[i + 1] - left) / grid_.cell_x_mm));
    for (int column = std::max(first, 0); column <= std::min(last, grid_.columns - 1); ++column) {
      parts_[grid_.index(column, row)] = RegionPart::kInside;
    }
  }
}

/// Marks every cell that a piece of a ring touches. In each row, a piece touches the cells from the
/// lowest to the highest X of the piece within the row.
void PlanRegion::mark_edge(const std::array<double, 2>& from, const std::array<double, 2>& to) {
  const double bottom = stock_.box().y_min + first_row_ * grid_.cell_y_mm;
  const double left = stock_.box().x_min + first_column_ * grid_.cell_x_mm;
  const bool rises = from[1] <= to[1];
  const auto& low = rises ? from : to;
  const auto& high = rises ? to : from;
  const auto x_at = [&](double y) {
    if (y <= low[1]) return low[0];
    if (y >= high[1]) return high[0];
    return low[0] + (y - low[1]) / (high[1] - low[1]) * (high[0] - low[0]);
  };
  // Fraction of a cell by which a piece is extended, because rounding may put a point on a cell's
  // border on either side.
  constexpr double kMore = 1.0e-6;
  const auto cell_of = [](double place) { return static_cast<int>(std::floor(place)); };
  const int first_row = cell_of((low[1] - bottom) / grid_.cell_y_mm - kMore);
  const int last_row = cell_of((high[1] - bottom) / grid_.cell_y_mm + kMore);
  for (int row = std::max(first_row, 0); row <= std::min(last_row, grid_.rows - 1); ++row) {
    const double x_low = x_at(bottom + row * grid_.cell_y_mm);
    const double x_high = x_at(bottom + (row + 1) * grid_.cell_y_mm);
    const auto [x_first, x_last] = std::minmax(x_low, x_high);
    const int first = cell_of((x_first - left) / grid_.cell_x_mm - kMore);
    const int last = cell_of((x_last - left) / grid_.cell_x_mm + kMore);
    for (int column = std::max(first, 0); column <= std::min(last, grid_.columns - 1); ++column) {
      parts_[grid_.index(column, row)] = RegionPart::kEdge;
    }
  }
}

bool PlanRegion::has(int column, int row) const {
  return column >= first_column_ && column < first_column_ + grid_.columns && row >= first_row_ &&
         row < first_row_ + grid_.rows;
}

RegionPart PlanRegion::part_of(int column, int row) const {
  return has(column, row) ? parts_[index_of(column, row)] : RegionPart::kOutside;
}

}  // namespace sim::stock
