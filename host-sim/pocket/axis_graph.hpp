#pragma once

#include <cstdint>
#include <vector>

#include "host-sim/pocket/owned_area.hpp"

namespace sim::pocket {

/// A point of an area's medial axis with the greatest disc around it that fits into the area.
struct AxisPoint {
  cnc::WideVec2 place{0.0, 0.0};
  double radius = 0.0;  ///< mm, exact for the place; 0 in a convex corner.
};

/// Two nodes that are joined, with the elements of the boundary that are equally far from what lies
/// between them.
struct AxisEdge {
  std::uint32_t from = 0;
  std::uint32_t to = 0;
  std::uint32_t left = 0;
  std::uint32_t right = 0;
  /// False of branches to joints of chords: no disc touches two places of a smooth row of elements
  /// along which the curvature grows, or falls.
  bool is_real = true;
};

struct AxisGraph {
  std::vector<AxisPoint> nodes;
  std::vector<AxisEdge> edges;
};

/// Returns the part of a Voronoi diagram of the boundary that lies in the area. Arcs are chopped
/// into chords within `sagitta_mm`, so that branches lead to where chords join, too.
///
/// Boost.Polygon computes the diagram in whole numbers, exactly in its topology; radii are
/// distances from the boundary itself. Throws as chords_of does.
[[nodiscard]] AxisGraph voronoi_graph(const OwnedArea& area, double sagitta_mm);

}  // namespace sim::pocket
