#include "host-sim/stock/carver.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace sim::stock {
namespace {

constexpr std::int32_t kUncut = std::numeric_limits<std::int32_t>::max();

/// Margin in mm for rounding errors of doubles at coordinates of up to kFarthestStockMm. The tool
/// is widened by this margin for lower bounds, and narrowed by it for upper bounds.
constexpr double kRoundingMm = 1.0e-9;

/// Returns the greatest whole number that is at most `value`. It avoids std::floor, which would be
/// a library call for each cell.
std::int32_t whole_below(double value) {
  const auto whole = static_cast<std::int32_t>(value);
  return static_cast<double>(whole) > value ? whole - 1 : whole;
}

/// Returns `index`, limited to the range `first` to `last`. The limits apply before the conversion
/// to int, so `index` may exceed the range of int.
int clamped(double index, int first, int last) {
  return static_cast<int>(std::clamp(index, static_cast<double>(first), static_cast<double>(last)));
}

bool is_same(const Pose& a, const Pose& b) {
  return a.x_mm == b.x_mm && a.y_mm == b.y_mm && a.z_mm == b.z_mm;
}

/// Returns whether both slacks of `stretch` are at least as great as the slacks of `other`.
bool has_slack_of(const Stretch& stretch, const Stretch& other) {
  return stretch.side_slack_mm >= other.side_slack_mm && stretch.up_slack_mm >= other.up_slack_mm;
}

}  // namespace

Carver::Carver(Stock& stock, const Cutter& cutter)
    : stock_{stock},
      profile_{profile_of(cutter)},
      half_x_mm_{0.5 * stock.cell_x_mm()},
      half_y_mm_{0.5 * stock.cell_y_mm()} {
  below_.nm.assign(static_cast<std::size_t>(stock.columns()) + 1, kUncut);
  above_ = below_;
}

// upper_nm() and lower_nm() return a height in nanometres above the stock's top. upper_nm() adds
// one nanometre and lower_nm() subtracts one, because the conversion rounds.
std::int32_t Carver::upper_nm(double height_mm) const {
  const double depth_nm = (stock_.box().top - height_mm) * kNmPerMm;
  if (depth_nm <= 0.0) return kUncut;
  const double deepest_nm = 2.0 - stock_.bottom_nm();
  return std::max(1 - whole_below(std::min(depth_nm, deepest_nm)), stock_.bottom_nm());
}

std::int32_t Carver::lower_nm(double height_mm) const {
  const double nm = (height_mm - stock_.box().top) * kNmPerMm;
  if (nm >= 0.0) return 0;
  const double deepest_nm = stock_.bottom_nm();
  return std::max(whole_below(std::max(nm, deepest_nm)) - 1, stock_.bottom_nm());
}

Carver::Range Carver::touched_cells(const SweptSurface& surface, int row, bool ahead_only) const {
  const double y = stock_.box().y_min + (2 * row + 1) * half_y_mm_;
  const double corner = std::sqrt(half_x_mm_ * half_x_mm_ + half_y_mm_ * half_y_mm_);
  auto extent = surface.extent_at(y, corner);
  if (!extent) return {};
  if (ahead_only) *extent = surface.ahead_of_start(*extent, y, corner);
  if (!(extent->low <= extent->high)) return {};
  const double width = stock_.cell_x_mm();
  const double first = std::floor((extent->low - stock_.box().x_min) / width);
  const double last = std::floor((extent->high - stock_.box().x_min) / width);
  if (last < 0.0 || first >= stock_.columns()) return {};
  return {clamped(first, 0, stock_.columns() - 1), clamped(last, 0, stock_.columns() - 1)};
}

void Carver::list_rows(const SweptSurface& surface, bool upper_ahead_only, bool lower_ahead_only) {
  rows_.clear();
  const Interval ys = surface.extent_along_y();
  const double height = stock_.cell_y_mm();
  const double first = std::floor((ys.low - stock_.box().y_min) / height);
  const double last = std::floor((ys.high - stock_.box().y_min) / height);
  if (last < 0.0 || first >= stock_.rows()) return;
  first_row_ = clamped(first, 0, stock_.rows() - 1);
  const int last_row = clamped(last, 0, stock_.rows() - 1);
  for (int row = first_row_; row <= last_row; ++row) {
    rows_.push_back({touched_cells(surface, row, upper_ahead_only),
                     touched_cells(surface, row, lower_ahead_only)});
  }
}

Carver::Range Carver::upper_range_of(int row) const {
  const int index = row - first_row_;
  if (index < 0 || index >= static_cast<int>(rows_.size())) return {};
  return rows_[static_cast<std::size_t>(index)].upper;
}

/// Computes the upper bounds at the corners on the line below row `line`. Only corners of cells
/// whose upper bounds may change, above or below this line, are filled.
void Carver::fill_corners(Corners& corners, const SweptSurface& surface, int line) {
  for (int i = corners.filled.first; i <= corners.filled.last; ++i) {
    corners.nm[static_cast<std::size_t>(i)] = kUncut;
  }
  corners.filled = {};
  if (surface.is_empty()) return;
  const double y = stock_.box().y_min + line * stock_.cell_y_mm();
  const auto extent = surface.extent_at(y, 0.0);
  if (!extent) return;
  Range needed{std::numeric_limits<int>::max(), -1};
  for (const Range& range : {upper_range_of(line - 1), upper_range_of(line)}) {
    if (range.last < range.first) continue;
    needed = {std::min(needed.first, range.first), std::max(needed.last, range.last + 1)};
  }
  if (needed.last < needed.first) return;
  const double width = stock_.cell_x_mm();
  const double first = std::ceil((extent->low - stock_.box().x_min) / width);
  const double last = std::floor((extent->high - stock_.box().x_min) / width);
  if (last < needed.first || first > needed.last) return;
  corners.filled = {clamped(first, needed.first, needed.last),
                    clamped(last, needed.first, needed.last)};
  const std::int32_t plane_nm = upper_nm(surface.lowest_mm());
  for (int i = corners.filled.first; i <= corners.filled.last; ++i) {
    const double x = stock_.box().x_min + i * width;
    corners.nm[static_cast<std::size_t>(i)] =
        surface.is_plane() ? plane_nm : upper_nm(surface.height(x, y));
  }
}

/// Calls `function(column, cell)` for each column of a range.
template <typename Function>
void Carver::for_each_cell(int row, Range range, Function function) {
  for (int first = range.first; first <= range.last;) {
    const int tile = first / Stock::kTileCells;
    const int begin = tile * Stock::kTileCells;
    const int last = std::min(range.last, begin + Stock::kTileCells - 1);
    Cell* const cells = stock_.row_of_tile(tile, row);
    for (int column = first; column <= last; ++column) function(column, cells[column - begin]);
    first = last + 1;
  }
}

void Carver::sink_upper_bounds(int row, Range range) {
  std::int64_t fell = 0;
  std::int64_t surely_removed = 0;
  for_each_cell(row, range, [&](int column, Cell& cell) {
    const auto i = static_cast<std::size_t>(column);
    const std::int32_t upper = std::max(std::max(below_.nm[i], below_.nm[i + 1]),
                                        std::max(above_.nm[i], above_.nm[i + 1]));
    if (upper >= cell.upper_nm) return;
    fell += cell.upper_nm - upper;
    surely_removed += std::max(0, cell.lower_nm - upper - skin_nm_);
    cell.upper_nm = upper;
  });
  surely_removed_nm_ += surely_removed;
  stock_.count_removed(fell, 0);
}

void Carver::sink_lower_bounds(const SweptSurface& possible, int row, Range range) {
  const double y = stock_.box().y_min + (2 * row + 1) * half_y_mm_;
  std::int64_t fell = 0;
  for_each_cell(row, range, [&](int column, Cell& cell) {
    if (cell.lower_nm <= lowest_nm_) return;
    const double x = stock_.box().x_min + (2 * column + 1) * half_x_mm_;
    // A height of at least `enough_mm` cannot lower the cell's bound, even after rounding.
    const double enough_mm = stock_.box().top + (cell.lower_nm + 2) / kNmPerMm;
    const std::int32_t lower = lower_nm(possible.min_over(x, y, half_x_mm_, half_y_mm_, enough_mm));
    if (lower >= cell.lower_nm) return;
    fell += cell.lower_nm - lower;
    cell.lower_nm = lower;
  });
  stock_.count_removed(0, fell);
}

double Carver::sweep(const Stretch& stretch, double skin_mm) {
  const double side = stretch.side_slack_mm + kRoundingMm;
  const double up = stretch.up_slack_mm;
  const double top = stock_.box().top;
  const SweptSurface possible{possibly_taken(profile_, side, up), stretch.from, stretch.to, top};
  const SweptSurface sure{surely_taken(profile_, side, up), stretch.from, stretch.to, top};
  const bool goes_on = last_ && is_same(last_->to, stretch.from) && possible.has_old_rear();
  const bool upper_is_old = goes_on && has_slack_of(stretch, *last_);
  const bool lower_is_old = goes_on && has_slack_of(*last_, stretch);
  last_ = stretch;
  if (possible.is_empty()) return 0.0;
  list_rows(possible, upper_is_old, lower_is_old);
  if (rows_.empty()) return 0.0;
  lowest_nm_ = lower_nm(possible.lowest_mm());
  skin_nm_ = static_cast<std::int32_t>(std::lround(skin_mm * kNmPerMm));
  surely_removed_nm_ = 0;
  fill_corners(below_, sure, first_row_);
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    const int row = first_row_ + static_cast<int>(i);
    fill_corners(above_, sure, row + 1);
    sink_upper_bounds(row, rows_[i].upper);
    sink_lower_bounds(possible, row, rows_[i].lower);
    std::swap(below_, above_);
  }
  return static_cast<double>(surely_removed_nm_) * stock_.cell_x_mm() * stock_.cell_y_mm() /
         kNmPerMm;
}

}  // namespace sim::stock
