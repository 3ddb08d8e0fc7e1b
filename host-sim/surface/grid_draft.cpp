#include "host-sim/surface/grid_draft.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

#include "host-sim/surface/refusal.hpp"

namespace sim::surface {

std::string FaultyPoints::places(const GridDraft& grid) const {
  std::string text;
  for (std::size_t i = 0; i < std::min(count_, first_.size()); ++i) {
    const std::size_t index = first_[i];
    fmt::format_to(std::back_inserter(text),
                   "{}row {}, column {}",
                   i == 0 ? "" : "; ",
                   index / grid.columns + 1,
                   index % grid.columns + 1);
    if (grid.lines.empty() || grid.lines[index] != 0) continue;
    const Eigen::Vector3d& point = grid.points[index];
    fmt::format_to(std::back_inserter(text), " (x {:.3f}, y {:.3f})", point.x(), point.y());
  }
  if (count_ > first_.size()) text += fmt::format(" and {} more", count_ - first_.size());
  return text;
}

void refuse_points(const GridDraft& grid,
                   const FaultyPoints& faults,
                   const std::string& reason,
                   const std::string& remedy) {
  const std::size_t line = grid.lines.empty() ? 0 : grid.lines[faults.first()];
  refuse(grid.name, line, fmt::format("{} at {}", reason, faults.places(grid)), remedy);
}

}  // namespace sim::surface
