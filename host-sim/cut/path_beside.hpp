#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "host-sim/contour/contour_offset.hpp"
#include "host-sim/cut/clearance.hpp"
#include "host-sim/cut/outlines.hpp"
#include "host-sim/import/drawing.hpp"

namespace sim::cut {

/// The cut beside one outline, and what is to be known of it.
struct PathBeside {
  std::vector<std::vector<Stroke>> loops{};  ///< Empty where the outline vanishes.
  std::optional<drawing::Fault> failure{};   ///< There is no path, and why.
  std::vector<drawing::Fault> rests{};       ///< What stays uncut, as warnings.
  std::vector<drawing::Fault> gouges{};      ///< What is cut that must not be.
};

/// The edges of a drawing.
struct DrawnEdges {
  const drawing::Drawing& drawn;
  const std::vector<Outline>& outlines;
  const Clearance& near;  ///< All outlines that are cut beside their lines.
  double reach_mm;        ///< Nothing farther than that matters, mm.
};

/// Returns the cut at half a kerf beside an outline. May run beside others of itself, each with an
/// offset of its own.
[[nodiscard]] PathBeside path_beside(const DrawnEdges& edges,
                                     std::size_t contour,
                                     double half_kerf_mm,
                                     ContourOffset& offset);

}  // namespace sim::cut
