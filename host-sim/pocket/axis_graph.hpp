#pragma once

#include <cstdint>
#include <vector>

#include "host-sim/pocket/owned_area.hpp"

namespace sim::pocket {

/// A point of an area's medial axis, with the radius of the greatest disc around it in the area.
struct AxisPoint {
  cnc::WideVec2 place{0.0, 0.0};
  double radius = 0.0;  ///< Radius of the disc, mm; exact for the point, and 0 in a convex corner.
};

/// An edge between two nodes, with two elements of the boundary. All points of the edge are equally
/// far from both elements.
struct AxisEdge {
  std::uint32_t from = 0;
  std::uint32_t to = 0;
  std::uint32_t left = 0;
  std::uint32_t right = 0;
  /// Whether the edge belongs to the medial axis. False for branches that lead to a joint of two
  /// chords of a smooth row of elements. If the curvature along such a row only grows or only
  /// falls, no disc touches two of its points.
  bool is_real = true;
};

struct AxisGraph {
  std::vector<AxisPoint> nodes;
  std::vector<AxisEdge> edges;
};

/// Returns the part of the Voronoi diagram of the boundary that lies in the area. Arcs are divided
/// into chords within `sagitta_mm`, so branches also lead to the joints of chords.
///
/// Boost.Polygon computes the diagram in integers, so its topology is exact. Radii are distances
/// from the boundary itself, not from the chords. Throws the exceptions of chords_of().
[[nodiscard]] AxisGraph voronoi_graph(const OwnedArea& area, double sagitta_mm);

}  // namespace sim::pocket
