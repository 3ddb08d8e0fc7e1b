#pragma once

#include <string>

#include "host-sim/engrave/burn_raster.hpp"

namespace sim::engrave {

/// Returns a PNG of a raster, with one pixel for each pixel of the raster. Black is full power,
/// white is not burnt. Throws std::runtime_error if the PNG cannot be made.
[[nodiscard]] std::string burn_picture(const BurnRaster& raster);

}  // namespace sim::engrave
