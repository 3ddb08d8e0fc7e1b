#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "host-sim/cut/clearance.hpp"
#include "host-sim/cut/outlines.hpp"
#include "host-sim/cut/stroke.hpp"
#include "host-sim/import/drawing.hpp"

namespace sim::cut {

/// Returns a fault if the path of a cut cuts into a part; nothing otherwise. The fault names the
/// point where the path cuts deepest.
/// @param contour number of the contour in the drawing
/// @param edges all drawn edges, each with the number of its contour
[[nodiscard]] std::optional<drawing::Fault> gouge_of(const drawing::Drawing& drawn,
                                                     std::size_t contour,
                                                     const std::vector<Stroke>& loop,
                                                     const Clearance& edges,
                                                     double half_kerf_mm);

/// Returns a fault if a part lies against another part, edge to edge; nothing otherwise. A cut
/// between such parts makes at least one of them too small. The fault names the middle of the
/// longest edge along which parts lie against each other.
/// @param contour number of the contour in the drawing
/// @param outlines outline of each contour
/// @param edges all drawn edges, each with the number of its contour
/// @param half_kerf_mm half of the kerf of the contour
[[nodiscard]] std::optional<drawing::Fault> touch_of(const drawing::Drawing& drawn,
                                                     std::size_t contour,
                                                     const std::vector<Outline>& outlines,
                                                     const Clearance& edges,
                                                     double half_kerf_mm);

/// A stretch of a drawn line that stays uncut.
struct Rest {
  Place place{0.0, 0.0};  ///< Point in the middle of the stretch.
  double length_mm = 0.0;
};

/// Returns the stretches of a drawn line that are farther than a kerf from the beam's path. Usually
/// the path is half a kerf away. Such stretches occur in slots and in corners sharper than 60
/// degrees.
/// @param loops all paths of the beam along this outline
/// @param reach_mm distance at which searches find paths, at least the kerf
[[nodiscard]] std::vector<Rest> rests_along(const std::vector<Stroke>& outline,
                                            const std::vector<std::vector<Stroke>>& loops,
                                            double half_kerf_mm,
                                            double reach_mm);

/// Returns a warning for each uncut stretch of an outline.
[[nodiscard]] std::vector<drawing::Fault> rests_of(const drawing::Entity& entity,
                                                   const std::vector<Rest>& rests,
                                                   double half_kerf_mm);

}  // namespace sim::cut
