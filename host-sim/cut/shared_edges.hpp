#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <vector>

#include "host-sim/cut/outlines.hpp"

namespace sim::cut {

/// Parts that lie no farther apart than this lie against each other, mm.
inline constexpr double kTouchesMm = 0.01;

/// A stretch of a closed outline, mm along it; it goes on across the start where `to_mm` is not
/// greater.
struct EdgeStretch {
  std::size_t contour = 0;
  double from_mm = 0.0;
  double to_mm = 0.0;
};

/// A line along which two outlines lie against each other, or a point at which they touch.
struct SharedEdge {
  std::vector<Stroke> strokes{};        ///< As the first outline goes; none of a point.
  std::array<EdgeStretch, 2> beside{};  ///< The stretches of both outlines.
  std::array<std::size_t, 2> nodes{};   ///< At its start and its end.
  bool is_ring = false;                 ///< It is the whole of both outlines.
};

/// The lines along which outlines lie against each other, and the nodes at which they end.
struct SharedEdges {
  std::vector<SharedEdge> edges{};
  std::vector<Place> nodes{};
};

/// Finds the lines along which two outlines lie against each other, nowhere farther apart than
/// kTouchesMm: straight ones and arcs, whole edges and stretches of them. A line is that of the
/// outline which comes first; its ends are moved by 2 kTouchesMm at most to where other lines end.
/// Lines of 2 kTouchesMm or less are none. Points are corners that touch another outline where
/// neither outline has a line.
/// @param contours numbers of closed outlines
/// @param may_share whether two contours may share a line
[[nodiscard]] SharedEdges shared_edges(
    const std::vector<Outline>& outlines,
    const std::vector<std::size_t>& contours,
    const std::function<bool(std::size_t, std::size_t)>& may_share);

}  // namespace sim::cut
