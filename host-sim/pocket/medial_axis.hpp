#pragma once

#include <cstdint>
#include <vector>

#include "host-sim/pocket/axis_graph.hpp"

namespace sim::pocket {

/// A stretch of the axis between two nodes, none of them a node within it.
struct AxisChain {
  std::uint32_t from = 0;
  std::uint32_t to = 0;
  std::vector<AxisPoint> points;  ///< Two at least, both nodes among them.
};

/// The medial axis of an area: the centres of all discs in it that touch its boundary twice. Nodes
/// are where chains end or branch; in a part of the area that is a circle, one without chains.
struct MedialAxis {
  std::vector<AxisPoint> nodes;
  std::vector<AxisChain> chains;
};

struct AxisOptions {
  /// Between neighbours on a chain, in the plane and by the radius, mm. Arcs are chopped ten times
  /// as finely.
  double tolerance_mm = 1.0e-3;
  /// Branches count if their discs reach this far beyond the others, mm.
  double slack_mm = 1.0e-3;
};

/// Computes the medial axis of an area. Radii are exact distances from the boundary; points are
/// within the tolerance of the axis, which begins at r = 0 in each corner whose branch counts.
///
/// Time: n log n for n chords. Throws as chords_of does.
[[nodiscard]] MedialAxis medial_axis(const OwnedArea& area, const AxisOptions& options = {});

}  // namespace sim::pocket
