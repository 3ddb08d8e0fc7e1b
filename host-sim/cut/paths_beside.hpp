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

/// The compensated paths of the beam for one outline, and their faults.
struct PathBeside {
  std::vector<std::vector<Stroke>> loops{};
  /// Open lines in the middle of waste that is narrower than the kerf.
  std::vector<std::vector<Stroke>> middles{};
  std::optional<drawing::Fault> narrow{};   ///< A warning that reports these lines.
  std::optional<drawing::Fault> failure{};  ///< The reason why there is no path.
  /// The path of the outline also follows edges of other outlines.
  bool shares_edges = false;
  bool vanishes = false;                 ///< The outline is narrower than the kerf.
  std::vector<Rest> rests{};             ///< Stretches of the outline that stay uncut.
  std::vector<drawing::Fault> gouges{};  ///< Points where a path takes something off a part.
};

/// The edges of a drawing, with the kerf and the settings of their cuts.
struct DrawnEdges {
  const drawing::Drawing& drawn;
  const std::vector<Outline>& outlines;  ///< The outline of each contour.
  const Clearance& near;                 ///< All outlines that are cut at an offset.
  double reach_mm;                       ///< Edges farther away than this do not matter, mm.
  std::function<double(std::size_t)> half_kerf_mm;  ///< Returns half of the kerf of a contour.
  /// Returns the distance by which a cut along the middle of narrow waste may go into a contour,
  /// mm. 0: no such cut is permitted.
  std::function<double(std::size_t)> narrow_mm;
  /// Returns whether two contours that lie against each other are cut once along their common edge.
  std::function<bool(std::size_t, std::size_t)> may_share;
};

/// Returns by contour the paths at an offset of half the kerf from its outline. There are no paths
/// for an outline that is cut in another way. Outlines that come nearer to each other than the kerf
/// share their paths, with a warning. Outlines that lie against each other have the edge between
/// them in common if `may_share` permits. Where waste is narrower than the kerf and the settings
/// allow it, lines run along its middle, with a warning, too.
[[nodiscard]] std::vector<PathBeside> paths_beside(const DrawnEdges& edges,
                                                   std::vector<drawing::Fault>& warnings);

}  // namespace sim::cut
