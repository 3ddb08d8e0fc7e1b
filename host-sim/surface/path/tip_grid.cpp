#include "host-sim/surface/path/tip_grid.hpp"

#include <algorithm>
#include <limits>

namespace sim::surface {

TipGrid::TipGrid(const SurfaceTracer& tracer,
                 const PlanGrid& grid,
                 const std::function<void(double)>& progress)
    : grid_{grid},
      heights_(grid.size()),
      lowest_mm_{std::numeric_limits<double>::infinity()},
      highest_mm_{-lowest_mm_} {
  PathHeights::Hint hint;
  for (std::size_t row = 0; row < grid.rows(); ++row) {
    for (std::size_t column = 0; column < grid.columns(); ++column) {
      const double height = tracer.touched(grid.at(column, row), hint);
      heights_[grid.node(column, row)] = height;
      if (height == cnc::surface::kNoContact) continue;
      lowest_mm_ = std::min(lowest_mm_, height);
      highest_mm_ = std::max(highest_mm_, height);
    }
    if (progress) progress(static_cast<double>(row + 1) / static_cast<double>(grid.rows()));
  }
}

}  // namespace sim::surface
