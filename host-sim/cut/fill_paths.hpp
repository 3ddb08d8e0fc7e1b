#pragma once

#include <vector>

#include "host-sim/cut/layer_settings.hpp"
#include "host-sim/cut/stroke.hpp"
#include "host-sim/import/drawing.hpp"

namespace sim::cut {

/// The paths that fill an area, or the faults because of which there are none.
struct FillPaths {
  std::vector<std::vector<Stroke>> paths{};
  std::vector<drawing::Fault> faults{};
  std::vector<drawing::Fault> warnings{};
};

/// Returns the paths that fill an area with the pattern of the settings. The area is the set of
/// points that an odd number of contours encloses.
/// @param outlines strokes of closed contours, none of them empty
/// @param overscan_mm overscan of parallel lines, 0 or more
/// @param entity entity of the drawing that the faults name
[[nodiscard]] FillPaths fill_paths(const std::vector<std::vector<Stroke>>& outlines,
                                   const FillSettings& fill,
                                   double overscan_mm,
                                   const drawing::Entity& entity);

}  // namespace sim::cut
