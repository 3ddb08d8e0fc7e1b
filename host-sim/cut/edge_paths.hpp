#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <vector>

#include "host-sim/cut/clearance.hpp"
#include "host-sim/cut/outlines.hpp"
#include "host-sim/cut/shared_edges.hpp"

namespace sim::cut {

/// Paths of outlines that share edges.
struct EdgePaths {
  /// Closed path of each contour that shares an edge. The part is on its left.
  std::map<std::size_t, std::vector<Stroke>> of_contour{};
  /// For each path around all outlines: whether it is divided among the paths of contours.
  std::vector<bool> is_divided{};
};

/// Divides the paths around outlines that lie against each other. The path of each outline follows
/// its shared edges. Elsewhere it runs at an offset of half a kerf. From the end of a shared edge
/// it goes straight through the waste to the nearest point of a path around all outlines. The paths
/// of neighbours have these straight lines in common, too.
///
/// Guarantee: no path is within an outline. No path is nearer to an outline than half a kerf,
/// except along shared edges and on the straight lines, which are at most 4 half kerfs long. Each
/// path around all outlines is contained once in the paths of contours.
/// @param around closed paths at half a kerf around all outlines together, with the parts on their
/// left
/// @param near all outlines, with a reach of at least 4 half kerfs
/// @return nothing if a shared edge ends in waste that is too narrow for a path
[[nodiscard]] std::optional<EdgePaths> paths_along_edges(
    const std::vector<Outline>& outlines,
    const SharedEdges& shared,
    const std::vector<std::vector<Stroke>>& around,
    const Clearance& near,
    double half_kerf_mm);

}  // namespace sim::cut
