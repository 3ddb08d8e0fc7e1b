#pragma once

#include <cstdint>
#include <vector>

#include "host-sim/pocket/owned_area.hpp"

namespace sim::pocket {

/// A point of an area's medial axis, with the radius of the greatest disc around it in the area.
struct AxisPoint {
  cnc::WideVec2 place{0.0, 0.0};
  double radius = 0.0;  ///< mm, exact for the point; 0 in a convex corner.
};

/// Two nodes that are joined, with two elements of the boundary. The points between the nodes are
/// equally far from both elements.
struct AxisEdge {
  std::uint32_t from = 0;
  std::uint32_t to = 0;
  std::uint32_t left = 0;
  std::uint32_t right = 0;
  /// False for branches to joints of chords. No disc touches two points of a smooth row of elements
  /// along which the curvature only grows, or only falls.
  bool is_real = true;
};

struct AxisGraph {
  std::vector<AxisPoint> nodes;
  std::vector<AxisEdge> edges;
};

/// Returns the part of a Voronoi diagram of the boundary that lies in the area. Arcs are divided
/// into chords within `sagitta_mm`, so branches lead to the joints of chords, too.
///
/// Boost.Polygon computes the diagram in whole numbers, so its topology is exact. Radii are
/// distances from the boundary itself. Throws the exceptions of chords_of().
[[nodiscard]] AxisGraph voronoi_graph(const OwnedArea& area, double sagitta_mm);

}  // namespace sim::pocket
