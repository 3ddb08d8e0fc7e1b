#pragma once

#include "host-sim/contour/contour_offset.hpp"

namespace sim::surface {

/// Returns a contour whose loops are cut where they meet themselves after a short way: at a sharp
/// corner two lines that are beside their curves may cross before their ends.
/// @param reach_mm greatest length of what is cut off, without its first and last element
[[nodiscard]] Contour untangled(const Contour& contour, double reach_mm);

/// Returns whether elements of a contour meet anywhere but at the joints between neighbours.
/// Time: n log n where few are near each other.
[[nodiscard]] bool crosses_itself(const Contour& contour);

}  // namespace sim::surface
