#include "host-sim/cut/swept_area.hpp"

#include <algorithm>
#include <cmath>

namespace sim::cut {

std::int64_t SweptArea::cell_of(double mm) {
  return static_cast<std::int64_t>(std::floor(mm / kCellMm));
}

std::int64_t SweptArea::key_of(std::int64_t column, std::int64_t row) {
  constexpr std::int64_t kColumns = std::int64_t{1} << 31;
  return row * kColumns + column;
}

void SweptArea::add(const Place& centre, double radius_mm) {
  widest_mm_ = std::max(widest_mm_, radius_mm);
  cells_[key_of(cell_of(centre.x()), cell_of(centre.y()))].push_back({centre, radius_mm});
}

double SweptArea::depth_of(const Place& place) const {
  const double reach = widest_mm_ + kReachMm;
  double depth = -kReachMm;
  for (std::int64_t row = cell_of(place.y() - reach); row <= cell_of(place.y() + reach); ++row) {
    for (std::int64_t column = cell_of(place.x() - reach); column <= cell_of(place.x() + reach);
         ++column) {
      const auto found = cells_.find(key_of(column, row));
      if (found == cells_.end()) continue;
      for (const Disc& disc : found->second) {
        depth = std::max(depth, disc.radius_mm - drawing::distance(disc.centre, place));
      }
    }
  }
  return depth;
}

}  // namespace sim::cut
