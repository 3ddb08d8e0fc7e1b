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

/// Returns a picture as it lies on the machine. Quarter turns and mirrors keep its pixels. Under
/// any other map, the upright rectangle around the picture is sampled at least four times along
/// each burnt pixel. Samples outside of the picture belong to nothing.
/// @param to_mm maps points of the picture, in pixels from its upper left corner with y down, to mm
/// @param burnt_mm smaller side of the pixels that are burnt, above 0
/// @pre the map is finite, and it maps no area to a line
[[nodiscard]] UprightImage upright(const picture::GreyImage& image,
                                   const drawing::Transform& to_mm,
                                   double burnt_mm);

}  // namespace sim::engrave
