#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <vector>

#include "host-sim/cut/outlines.hpp"

namespace sim::cut {

/// Greatest distance at which parts lie against each other, mm.
inline constexpr double kTouchesMm = 0.01;

/// A stretch of a closed outline, given by distances along the outline. If `to_mm` is not greater
/// than `from_mm`, the stretch continues across the start of the outline.
struct EdgeStretch {
  std::size_t contour = 0;
  double from_mm = 0.0;
  double to_mm = 0.0;
};

/// A line along which two outlines lie against each other, or a point at which they touch.
struct SharedEdge {
  /// Strokes of the line in the direction of the first outline; none for a point.
  std::vector<Stroke> strokes{};
  std::array<EdgeStretch, 2> beside{};  ///< Stretches of the two outlines along the line.
  /// Numbers of the nodes at the start and the end of the line.
  std::array<std::size_t, 2> nodes{};
  bool is_ring = false;  ///< Whether the line is the whole of both outlines.
};

/// The lines along which outlines lie against each other and the points at which they touch, with
/// their nodes.
struct SharedEdges {
  std::vector<SharedEdge> edges{};
  std::vector<Place> nodes{};
};

/// Finds the lines along which two outlines lie against each other, nowhere farther apart than
/// kTouchesMm. Lines may be straight or arcs, whole edges or stretches of edges. The geometry of a
/// line is that of the outline that comes first in the list. Ends of lines move by at most 2
/// kTouchesMm, to ends of other lines. Lines of 2 kTouchesMm or less are ignored. Also finds
/// points: corners that touch another outline where neither outline has a line.
/// @param contours numbers of closed outlines
/// @param may_share returns whether two contours may share a line
[[nodiscard]] SharedEdges shared_edges(
    const std::vector<Outline>& outlines,
    const std::vector<std::size_t>& contours,
    const std::function<bool(std::size_t, std::size_t)>& may_share);

}  // namespace sim::cut
