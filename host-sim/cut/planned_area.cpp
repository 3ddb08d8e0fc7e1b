#include "host-sim/cut/planned_area.hpp"

#include <algorithm>

#include "host-sim/cut/swept_area.hpp"

namespace sim::cut {

void PlannedArea::add(const Stroke& stroke, double radius_mm) {
  strokes_.try_emplace(radius_mm, radius_mm + SweptArea::kReachMm).first->second.add(stroke, 0);
}

void PlannedArea::prepare() {
  for (auto& [radius_mm, strokes] : strokes_) strokes.prepare();
}

double PlannedArea::depth_of(const Place& place) const {
  double depth = -SweptArea::kReachMm;
  for (const auto& [radius_mm, strokes] : strokes_) {
    depth = std::max(depth, radius_mm - strokes.nearest(place).distance_mm);
  }
  return depth;
}

}  // namespace sim::cut
