#pragma once

#include <span>
#include <string>

#include "host-sim/contour/contour_offset.hpp"

namespace sim {

/// Contours as a DXF of release 12: a closed POLYLINE with bulges for each loop, mm,
/// contour number n on layer `n`, from 1 on; with as many digits as each number needs.
[[nodiscard]] std::string dxf_of_contours(std::span<const Contour> contours);

}  // namespace sim
