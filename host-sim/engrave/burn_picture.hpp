#pragma once

#include <string>

#include "host-sim/engrave/burn_raster.hpp"

namespace sim::engrave {

/// Returns a PNG of a raster, a pixel for each of it: black is full power, white is not burnt.
/// Throws std::runtime_error where it cannot be made.
[[nodiscard]] std::string burn_picture(const BurnRaster& raster);

}  // namespace sim::engrave
