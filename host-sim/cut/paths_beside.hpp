#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <vector>

#include "host-sim/cut/clearance.hpp"
#include "host-sim/cut/kerf_faults.hpp"
#include "host-sim/cut/outlines.hpp"
#include "host-sim/import/drawing.hpp"

namespace sim::cut {

/// The compensated paths of the beam along one outline, and their faults.
struct PathBeside {
  std::vector<std::vector<Stroke>> loops{};
  /// Open lines in the middle of waste that is narrower than the kerf.
  std::vector<std::vector<Stroke>> middles{};
  std::optional<drawing::Fault> narrow{};   ///< Warning about the lines of `middles`.
  std::optional<drawing::Fault> failure{};  ///< The reason why there is no path, as a fault.
  /// Whether the path follows edges that the outline shares with other outlines.
  bool shares_edges = false;
  /// Whether the outline is narrower than the kerf, so that there is no path.
  bool vanishes = false;
  std::vector<Rest> rests{};  ///< Stretches of the outline that stay uncut.
  /// Faults at the points where a path takes something off a part.
  std::vector<drawing::Fault> gouges{};
};

/// The edges of a drawing, with the kerfs and settings of their cuts.
struct DrawnEdges {
  const drawing::Drawing& drawn;
  const std::vector<Outline>& outlines;  ///< The outline of each contour.
  const Clearance& near;                 ///< Index of all outlines that are cut at an offset.
  double reach_mm;                       ///< Greatest distance at which edges matter, mm.
  /// Function that returns half of the kerf of a contour.
  std::function<double(std::size_t)> half_kerf_mm;
  /// Returns the greatest distance by which a cut along the middle of narrow waste may go into a
  /// contour, mm. It is 0 if no such cut is permitted.
  std::function<double(std::size_t)> narrow_mm;
  /// Returns whether two contours that lie against each other may be cut once along their common
  /// edge.
  std::function<bool(std::size_t, std::size_t)> may_share;
};

/// Returns, for each contour, the paths at an offset of half the kerf from its outline. A contour
/// that is not cut at an offset has no paths. Outlines that are nearer to each other than the kerf
/// share their paths, with a warning. Outlines that lie against each other are cut once along their
/// common edge if `may_share` permits this. If waste is narrower than the kerf and the settings
/// permit it, lines run along its middle, also with a warning.
[[nodiscard]] std::vector<PathBeside> paths_beside(const DrawnEdges& edges,
                                                   std::vector<drawing::Fault>& warnings);

}  // namespace sim::cut
