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

/// Returns crowds of outlines. A crowd holds outlines whose paths take something off each other,
/// with their neighbours within the kerf. Each outline is in at most one crowd. Outlines with
/// another kerf are in none.
/// @param beside one for each outline
/// @param half_kerf_mm returns half of the kerf of an outline
[[nodiscard]] std::vector<std::vector<std::size_t>> crowds_of(
    const std::vector<Outline>& outlines,
    const std::vector<PathBeside>& beside,
    const Clearance& edges,
    const std::function<double(std::size_t)>& half_kerf_mm);

/// Returns a warning for the first outline of a crowd whose path takes something off another
/// outline. It names the point where the path takes off most: there the outlines hold together once
/// they share a path.
[[nodiscard]] std::vector<drawing::Fault> held_together(const drawing::Drawing& drawn,
                                                        const std::vector<std::size_t>& crowd,
                                                        const std::vector<PathBeside>& beside);

/// Cuts between the outlines of a crowd.
struct CutsBetween {
  /// Lines in the middle of narrow waste, where outlines do not hold together.
  std::vector<std::vector<Stroke>> middles{};
  SharedEdges edges{};  ///< Edges along which the outlines are cut apart.
};

/// Moves the paths along outlines that touch, or that are nearer to each other than the kerf. Then
/// no path takes anything off any of these outlines, except along shared edges. Elsewhere the
/// outlines are cut as one part, which holds together where they are nearer than the kerf. Examples
/// are parts that touch at a corner, and scraps next to a notch.
///
/// A path belongs to the outline next to which it begins. An outline without a path of its own is
/// cut with the others.
/// @param edges reach of at least two kerfs
/// @param beside paths of the outlines of the crowd; changed only if this returns true. The outline
/// whose path encloses the largest area has the middles, which are cut before it
/// @return false if no such paths exist, or if more than `kMaxHoldMm` would hold at one point,
/// because these are parts that lie against each other
[[nodiscard]] bool part_crowd(const DrawnEdges& edges,
                              const std::vector<std::size_t>& crowd,
                              const CutsBetween& between,
                              ContourOffset& offset,
                              std::vector<PathBeside>& beside);

/// The greatest length of an edge at which neighbours may hold together, mm.
inline constexpr double kMaxHoldMm = 3.0;

}  // namespace sim::cut
