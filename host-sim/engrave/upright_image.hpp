#pragma once

#include "host-sim/import/place.hpp"
#include "host-sim/picture/grey_image.hpp"

namespace sim::engrave {

/// A picture whose rows run along X, from the top, and the rectangle that it fills, mm.
struct UprightImage {
  picture::GreyImage image{};
  drawing::Place low_mm{0.0, 0.0};
  drawing::Place high_mm{0.0, 0.0};
};

/// Returns a picture as it lies on the machine. Quarter turns and mirrors keep its pixels; any
/// other map samples it within the upright rectangle around it, at least four times along each
/// burnt pixel, where what is beside the picture belongs to nothing.
/// @param to_mm of places in the picture, in pixels from its upper left corner, y down
/// @param burnt_mm the smaller side of the pixels that are burnt, above 0
/// @pre the map is finite, and no area becomes a line
[[nodiscard]] UprightImage upright(const picture::GreyImage& image,
                                   const drawing::Transform& to_mm,
                                   double burnt_mm);

}  // namespace sim::engrave
