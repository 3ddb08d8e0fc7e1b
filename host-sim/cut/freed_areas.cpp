#include "host-sim/cut/freed_areas.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "planner/base/contract.hpp"

namespace sim::cut {

std::int64_t FreedAreas::cell_of(double mm) const {
  return static_cast<std::int64_t>(std::floor(mm / cell_mm_));
}

double FreedAreas::cells_in(const Box& box) const {
  return ((box.x1 - box.x0) / cell_mm_ + 1.0) * ((box.y1 - box.y0) / cell_mm_ + 1.0);
}

void FreedAreas::add(std::uint32_t number, std::shared_ptr<const LoopArea> area) {
  CNC_ASSERT(!has(number));
  if (met_.size() <= number) met_.resize(number + std::size_t{1}, 0);
  const Box box = area->box();
  areas_.emplace(number, std::move(area));
  if (cells_in(box) > kMaxCells) {
    large_.push_back(number);
    return;
  }
  for_cells(box, [&](std::int64_t column, std::int64_t row) {
    cells_[key_of(column, row)].push_back(number);
  });
}

void FreedAreas::remove(std::uint32_t number) {
  const Box box = area(number).box();
  areas_.erase(number);
  if (std::erase(large_, number) != 0) return;
  for_cells(box, [&](std::int64_t column, std::int64_t row) {
    const auto cell = cells_.find(key_of(column, row));
    std::erase(cell->second, number);
    if (cell->second.empty()) cells_.erase(cell);
  });
}

}  // namespace sim::cut
