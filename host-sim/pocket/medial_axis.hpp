#pragma once

#include <cstdint>
#include <vector>

#include "host-sim/pocket/axis_graph.hpp"

namespace sim::pocket {

/// A stretch of the medial axis between two nodes, without a node in between.
struct AxisChain {
  std::uint32_t from = 0;
  std::uint32_t to = 0;
  /// Points of the chain, at least two. The first and the last are the nodes.
  std::vector<AxisPoint> points;
};

/// The medial axis of an area: the centres of all discs in the area that touch its boundary twice.
/// Nodes are the points where chains end or branch. A part of the area that is a circle has one
/// node without chains.
struct MedialAxis {
  std::vector<AxisPoint> nodes;
  std::vector<AxisChain> chains;
};

struct AxisOptions {
  /// Tolerance between neighbouring points of a chain, in the plane and in the radius, mm. Arcs are
  /// divided ten times more finely.
  double tolerance_mm = 1.0e-3;
  /// Least distance by which the discs of a branch must reach beyond the other discs, mm. A branch
  /// with a smaller reach is dropped.
  double slack_mm = 1.0e-3;
};

/// Computes the medial axis of an area. Radii are exact distances from the boundary. Points are
/// within the tolerance of the axis. In each corner whose branch is kept, the axis begins with
/// radius 0.
///
/// Time: n log n for n chords. Throws the exceptions of chords_of().
[[nodiscard]] MedialAxis medial_axis(const OwnedArea& area, const AxisOptions& options = {});

}  // namespace sim::pocket
