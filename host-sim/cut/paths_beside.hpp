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

/// The paths of the beam beside one outline, and their faults.
struct PathBeside {
  std::vector<std::vector<Stroke>> loops{};
  /// Open lines in the middle of waste that is narrower than the kerf.
  std::vector<std::vector<Stroke>> middles{};
  std::optional<drawing::Fault> narrow{};   ///< A warning that tells of these lines.
  std::optional<drawing::Fault> failure{};  ///< Why there is no path.
  bool shares_edges = false;                ///< Its path goes along edges of other outlines, too.
  bool vanishes = false;                    ///< The outline is narrower than the kerf.
  std::vector<Rest> rests{};                ///< Stretches of the outline that stay uncut.
  std::vector<drawing::Fault> gouges{};     ///< Places where a path takes something off a part.
};

/// The edges of a drawing, and the kerf of their cuts.
struct DrawnEdges {
  const drawing::Drawing& drawn;
  const std::vector<Outline>& outlines;  ///< By contour.
  const Clearance& near;                 ///< All outlines that are cut beside their lines.
  double reach_mm;                       ///< No edge that is farther off matters, mm.
  std::function<double(std::size_t)> half_kerf_mm;  ///< Of a contour.
  /// Returns by how much a cut along the middle of narrow waste may go into a contour, mm; 0: there
  /// is none.
  std::function<double(std::size_t)> narrow_mm;
  /// Returns whether two contours that lie against each other are cut once along their edge.
  std::function<bool(std::size_t, std::size_t)> may_share;
};

/// Returns by contour the paths beside its outline at half of its kerf; no paths where an outline
/// is cut in another way. Outlines that come nearer to each other than the kerf share their paths,
/// with a warning; those that lie against each other, and may, have the edge between them in
/// common. Where waste is narrower than the kerf and their settings say so, lines go along its
/// middle, with a warning, too.
[[nodiscard]] std::vector<PathBeside> paths_beside(const DrawnEdges& edges,
                                                   std::vector<drawing::Fault>& warnings);

}  // namespace sim::cut
