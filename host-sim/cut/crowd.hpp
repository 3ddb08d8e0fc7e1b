#pragma once

#include <cstddef>
#include <functional>
#include <vector>

#include "host-sim/contour/contour_offset.hpp"
#include "host-sim/cut/clearance.hpp"
#include "host-sim/cut/outlines.hpp"
#include "host-sim/cut/paths_beside.hpp"
#include "host-sim/cut/shared_edges.hpp"

namespace sim::cut {

/// Returns crowds of outlines. A crowd consists of outlines whose paths cut into each other, and of
/// the outlines that are nearer to these than the kerf. Each outline is in at most one crowd.
/// Crowds whose outlines have different kerfs are left out.
/// @param beside the paths of each outline
/// @param half_kerf_mm returns half of the kerf of an outline
[[nodiscard]] std::vector<std::vector<std::size_t>> crowds_of(
    const std::vector<Outline>& outlines,
    const std::vector<PathBeside>& beside,
    const Clearance& edges,
    const std::function<double(std::size_t)>& half_kerf_mm);

/// Returns a warning that the outlines of a crowd stay connected after the cut. The warning names
/// the first outline whose path cuts into another outline, and the point where the path cuts
/// deepest. If the outlines share a path, they stay connected at this point.
[[nodiscard]] std::vector<drawing::Fault> held_together(const drawing::Drawing& drawn,
                                                        const std::vector<std::size_t>& crowd,
                                                        const std::vector<PathBeside>& beside);

/// Cuts that separate the outlines of a crowd.
struct CutsBetween {
  /// Lines in the middle of narrow waste, where the cut separates the outlines.
  std::vector<std::vector<Stroke>> middles{};
  SharedEdges edges{};  ///< Shared edges along which the cut separates the outlines.
};

/// Moves the paths along outlines that touch, or that are nearer to each other than the kerf. Then
/// no path cuts into any of these outlines, except along shared edges. Apart from shared edges, the
/// outlines are cut as one part, which stays connected where they are nearer to each other than the
/// kerf. Examples are parts that touch at a corner, and scraps next to a notch.
///
/// A path belongs to the outline at which it begins. An outline at which no path begins is cut
/// together with the others.
/// @param edges drawn edges with a reach of at least two kerfs
/// @param beside paths of the outlines of the crowd; changed only if this function returns true.
/// The outline whose path encloses the largest area gets the middles, which are cut before this
/// path
/// @return false if no such paths exist, or if outlines would stay connected along more than
/// kMaxHoldMm, because they are then parts that lie against each other
[[nodiscard]] bool part_crowd(const DrawnEdges& edges,
                              const std::vector<std::size_t>& crowd,
                              const CutsBetween& between,
                              ContourOffset& offset,
                              std::vector<PathBeside>& beside);

/// Greatest length of an edge along which neighbours may stay connected, mm.
inline constexpr double kMaxHoldMm = 3.0;

}  // namespace sim::cut
