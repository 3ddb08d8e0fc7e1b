#pragma once

#include <cstddef>
#include <vector>

#include "host-sim/surface/path/tip_grid.hpp"

namespace sim::surface {

/// A node from which distances are measured, and the distance in mm with which this node starts.
struct DistanceSource {
  std::size_t node = 0;
  double distance_mm = 0.0;
};

/// For each node of a grid the length in mm of the shortest path, over the heights of the tip, to
/// one of some sources. Paths are straight over the triangles of neighbouring nodes. A distance is
/// thus too long by a share that falls with the pitch; the share is larger where the surface is
/// steeper than 65 degrees.
class DistanceMap {
 public:
  /// @param tips heights of the tip; they outlive this object
  /// @param sources source nodes; each has contact
  DistanceMap(const TipGrid& tips, const std::vector<DistanceSource>& sources);

  [[nodiscard]] const PlanGrid& grid() const { return tips_->grid(); }
  /// Returns the distance of a node; infinity if nothing is under the tool there or no path leads
  /// to the node.
  [[nodiscard]] double at(std::size_t node) const { return distances_[node]; }
  /// Returns the greatest finite distance, at least 0.
  [[nodiscard]] double greatest() const;

 private:
  class March;

  const TipGrid* tips_;
  std::vector<double> distances_;
};

/// Returns the nodes at the border of the area in which something is under the tool, with their
/// distances from that border.
[[nodiscard]] std::vector<DistanceSource> border_sources(const SurfaceTracer& tracer,
                                                         const TipGrid& tips);

}  // namespace sim::surface
