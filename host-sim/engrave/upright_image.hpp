#pragma once

#include "host-sim/import/place.hpp"
#include "host-sim/picture/grey_image.hpp"

namespace sim::engrave {

/// A picture whose rows run along X, from the top, with the rectangle that the picture fills, mm.
struct UprightImage {
  picture::GreyImage image{};
  drawing::Place low_mm{0.0, 0.0};
  drawing::Place high_mm{0.0, 0.0};
};

/// Returns a picture as it appears on the machine. Quarter turns and mirroring keep its pixels. Any
/// other map requires sampling of the upright rectangle around the picture. There are four samples
/// along each burnt pixel, or as many as the limit of pixels allows. Samples outside of the picture
/// are not covered.
/// @param to_mm maps points of the picture, in pixels from its upper left corner with y down, to mm
/// @param burnt_mm length of the shorter side of a burnt pixel, above 0
/// @pre the map is finite, and its determinant is not 0
[[nodiscard]] UprightImage upright(const picture::GreyImage& image,
                                   const drawing::Transform& to_mm,
                                   double burnt_mm);

}  // namespace sim::engrave
