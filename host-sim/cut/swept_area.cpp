#include "host-sim/cut/swept_area.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace sim::cut {

bool SweptArea::Group::may_be_deeper(const Place& place, double depth_mm) const {
  constexpr double kRounding = 1.0 + 1.0e-9;
  const double farthest_mm = widest_mm - depth_mm;
  return farthest_mm > 0.0 && squared_distance(place) <= kRounding * farthest_mm * farthest_mm;
}

double SweptArea::Group::squared_distance(const Place& place) const {
  const double x = std::max({centres.x0 - place.x(), place.x() - centres.x1, 0.0});
  const double y = std::max({centres.y0 - place.y(), place.y() - centres.y1, 0.0});
  return x * x + y * y;
}

std::int64_t SweptArea::cell_of(double mm) {
  return static_cast<std::int64_t>(std::floor(mm / kCellMm));
}

std::int64_t SweptArea::key_of(std::int64_t column, std::int64_t row) {
  constexpr std::int64_t kColumns = std::int64_t{1} << 31;
  return row * kColumns + column;
}

void SweptArea::add(const Place& centre, double radius_mm) {
  widest_mm_ = std::max(widest_mm_, radius_mm);
  Cell& cell = cells_[key_of(cell_of(centre.x()), cell_of(centre.y()))];
  const cnc::contour::FlatBox<double> box{centre.x(), centre.y(), centre.x(), centre.y()};
  if (cell.discs.size() % kGroup == 0) cell.groups.push_back({.centres = box});
  cell.discs.push_back({centre, radius_mm});
  Group& group = cell.groups.back();
  group.centres.include(box);
  group.widest_mm = std::max(group.widest_mm, radius_mm);
}

/// Calls `visit` with the cell and the number of each group that may contain a point, or may be
/// within kReachMm of it.
template <typename Visit>
void SweptArea::visit_groups(const Place& place, const Visit& visit) const {
  const double reach = widest_mm_ + kReachMm;
  for (std::int64_t row = cell_of(place.y() - reach); row <= cell_of(place.y() + reach); ++row) {
    for (std::int64_t column = cell_of(place.x() - reach); column <= cell_of(place.x() + reach);
         ++column) {
      const auto found = cells_.find(key_of(column, row));
      if (found == cells_.end()) continue;
      for (std::size_t i = 0; i < found->second.groups.size(); ++i) visit(found->second, i);
    }
  }
}

double SweptArea::depth_of(const Place& place) const {
  double depth = -kReachMm;
  const auto measure = [&](const Cell& cell, std::size_t group) {
    const std::size_t end = std::min(cell.discs.size(), (group + 1) * kGroup);
    for (std::size_t i = group * kGroup; i < end; ++i) {
      const Disc& disc = cell.discs[i];
      depth = std::max(depth, disc.radius_mm - drawing::distance(disc.centre, place));
    }
  };
  // The nearest group is measured first. Most other groups can then be skipped, because no point of
  // them is deeper.
  const Cell* nearest_cell = nullptr;
  std::size_t nearest = 0;
  double least = std::numeric_limits<double>::infinity();
  visit_groups(place, [&](const Cell& cell, std::size_t group) {
    const double squared = cell.groups[group].squared_distance(place);
    if (squared >= least) return;
    least = squared;
    nearest_cell = &cell;
    nearest = group;
  });
  if (nearest_cell == nullptr) return depth;
  measure(*nearest_cell, nearest);
  visit_groups(place, [&](const Cell& cell, std::size_t group) {
    if (cell.groups[group].may_be_deeper(place, depth)) measure(cell, group);
  });
  return depth;
}

}  // namespace sim::cut
