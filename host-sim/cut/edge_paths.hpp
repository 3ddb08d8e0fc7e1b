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
  /// By contour that shares an edge, its closed path, with the part on its left.
  std::map<std::size_t, std::vector<Stroke>> of_contour{};
  std::vector<bool> is_divided{};  ///< By path around all: it is in paths of contours.
};

/// Divides the paths around outlines that lie against each other: the path of each outline goes
/// along its shared edges and elsewhere half a kerf beside it. From the end of a shared edge it
/// goes straight through the waste to the nearest point of the path around all, so that paths of
/// neighbours have these lines, too, in common.
///
/// Guarantee: no path is within an outline, or nearer to one than half a kerf but along shared
/// edges and on those straight lines, which are 4 half kerfs long at most; each path around all is
/// in the paths of contours once.
/// @param around closed paths half a kerf beside all outlines together, with the parts on their
/// left
/// @param near all outlines, reach of 4 half kerfs at least
/// @return nothing where a shared edge ends in waste that is too narrow, or that no path is in
[[nodiscard]] std::optional<EdgePaths> paths_along_edges(
    const std::vector<Outline>& outlines,
    const SharedEdges& shared,
    const std::vector<std::vector<Stroke>>& around,
    const Clearance& near,
    double half_kerf_mm);

}  // namespace sim::cut
