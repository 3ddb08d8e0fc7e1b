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

/// Returns sets of outlines whose paths take something off each other, with their neighbours within
/// the kerf; each outline is in one set at most. Outlines with another kerf are in none.
/// @param beside one for each outline
/// @param half_kerf_mm of an outline
[[nodiscard]] std::vector<std::vector<std::size_t>> crowds_of(
    const std::vector<Outline>& outlines,
    const std::vector<PathBeside>& beside,
    const Clearance& edges,
    const std::function<double(std::size_t)>& half_kerf_mm);

/// Returns a warning for the first outline of a crowd whose path takes something off another, where
/// that is most: there they hold together once they share a path.
[[nodiscard]] std::vector<drawing::Fault> held_together(const drawing::Drawing& drawn,
                                                        const std::vector<std::size_t>& crowd,
                                                        const std::vector<PathBeside>& beside);

/// Cuts between the outlines of a crowd.
struct CutsBetween {
  /// Lines in the middle of narrow waste, where outlines do not hold together.
  std::vector<std::vector<Stroke>> middles{};
  SharedEdges edges{};  ///< Edges along which they are cut apart.
};

/// Moves paths beside outlines that touch, or are nearer to each other than the kerf, so that none
/// takes anything off any of them but along shared edges: elsewhere they are cut as one part, which
/// holds together where they are so near. That is what becomes of parts that touch at a corner, and
/// of scraps beside a notch.
///
/// A path belongs to the outline beside which it begins; one that has none is cut with the others.
/// @param edges reach of two kerfs at least
/// @param beside paths of the outlines of the crowd; changed only where this returns true. The
/// outline with the longest way around has the middles, which are cut before it
/// @return false where no such paths exist, or more than `kMostHoldMm` would hold at one place:
///         these are parts that lie against each other
[[nodiscard]] bool part_crowd(const DrawnEdges& edges,
                              const std::vector<std::size_t>& crowd,
                              const CutsBetween& between,
                              ContourOffset& offset,
                              std::vector<PathBeside>& beside);

/// The greatest length of an edge at which neighbours may hold together, mm.
inline constexpr double kMostHoldMm = 3.0;

}  // namespace sim::cut
