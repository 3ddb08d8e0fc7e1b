#pragma once

#include <span>
#include <string>

#include "host-sim/contour/contour_offset.hpp"

namespace sim {

/// Returns contours as a DXF file of release 12, in mm. Each loop is a closed POLYLINE with bulges.
/// Contour number n, counted from 1, is on layer `n`. Numbers have as many digits as are needed to
/// read them back unchanged.
[[nodiscard]] std::string dxf_of_contours(std::span<const Contour> contours);

}  // namespace sim
