#pragma once

#include <cstddef>
#include <vector>

#include "host-sim/surface/path/tip_grid.hpp"

namespace sim::surface {

/// A node from which distances are measured, and its own distance from there, mm.
struct DistanceSource {
  std::size_t node = 0;
  double distance_mm = 0.0;
};

/// For each node of a grid the length of the shortest way over the tip's heights to one of some
/// sources, mm. Ways go straight over the triangles of neighbouring nodes, so that a distance is
/// too long by a share that falls with the pitch, and by more where the surface is steeper than 65
/// degrees.
class DistanceMap {
 public:
  /// @param sources nodes with contact @pre the tips outlive this
  DistanceMap(const TipGrid& tips, const std::vector<DistanceSource>& sources);

  [[nodiscard]] const PlanGrid& grid() const { return tips_->grid(); }
  /// Returns the distance of a node, infinity where nothing is under the tool or no way leads.
  [[nodiscard]] double at(std::size_t node) const { return distances_[node]; }
  /// Returns the greatest finite distance, at least 0.
  [[nodiscard]] double greatest() const;

 private:
  class March;

  const TipGrid* tips_;
  std::vector<double> distances_;
};

/// Returns the nodes at the border of the area in which something is under the tool.
[[nodiscard]] std::vector<DistanceSource> border_sources(const SurfaceTracer& tracer,
                                                         const TipGrid& tips);

}  // namespace sim::surface
