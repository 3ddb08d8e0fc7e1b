#include "planner/motion/lookahead/zone_edges.hpp"

namespace cnc::motion {

void ZoneEdges::add(const BlockZones& head, const BlockZones& tail, float length) {
  for (const LimitZone& zone : head) insert(zone.length, length);
  for (const LimitZone& zone : tail) {
    if (zone.length > 0.0F) insert(length - zone.length, length);
  }
}

/// Inserts an edge if it is within the block. Keeps the edges in order, and each distance only
/// once.
void ZoneEdges::insert(float distance, float length) {
  if (distance <= 0.0F || distance >= length) return;
  const auto count = static_cast<std::size_t>(count_);
  std::size_t index = count;
  while (index > 0 && distances_[index - 1] >= distance) --index;
  if (index < count && distances_[index] <= distance) return;
  for (std::size_t k = count; k > index; --k) distances_[k] = distances_[k - 1];
  distances_[index] = distance;
  ++count_;
}

void ZoneEdges::number(const ArcShape& arc, const ArcGrid& grid) {
  int of_grid = 1;
  int kept = 0;
  for (int k = 0; k < count_; ++k) {
    const float edge = distance(k);
    while (of_grid < grid.count() && grid.distance(arc, of_grid) < edge) ++of_grid;
    if (of_grid < grid.count() && grid.distance(arc, of_grid) <= edge) continue;
    distances_[static_cast<std::size_t>(kept)] = edge;
    boundaries_[static_cast<std::size_t>(kept)] = of_grid + kept;
    ++kept;
  }
  count_ = kept;
}

}  // namespace cnc::motion
