#pragma once

#include <cstddef>
#include <vector>

#include "host-sim/surface/path/tip_grid.hpp"

namespace sim::surface {

/// A node from which distances are measured, and the node's initial distance, mm.
struct DistanceSource {
  std::size_t node = 0;
  double distance_mm = 0.0;
};

/// Distances of the nodes of a grid from the nearest source, mm: the length of the shortest path
/// over the surface of the tip. Paths are straight within the triangles of neighbouring nodes, so
/// that distances are slightly too great. The relative error decreases with the pitch. It is
/// greater where the surface is steeper than 65 degrees.
class DistanceMap {
 public:
  /// @param tips heights of the tip; they outlive this object
  /// @param sources source nodes, all with contact
  DistanceMap(const TipGrid& tips, const std::vector<DistanceSource>& sources);

  [[nodiscard]] const PlanGrid& grid() const { return tips_->grid(); }
  /// Returns the distance of a node from the nearest source; infinity if nothing is under the tool
  /// at the node or no path leads to it.
  [[nodiscard]] double at(std::size_t node) const { return distances_[node]; }
  /// Returns the greatest finite distance, at least 0.
  [[nodiscard]] double greatest() const;

 private:
  class March;

  const TipGrid* tips_;
  std::vector<double> distances_;
};

/// Returns the nodes along the border of the area in which something is under the tool, with their
/// distances from the border.
[[nodiscard]] std::vector<DistanceSource> border_sources(const SurfaceTracer& tracer,
                                                         const TipGrid& tips);

}  // namespace sim::surface
