#pragma once

#include "host-sim/contour/contour_offset.hpp"

namespace sim::surface {

/// Returns a contour without the short detours at which its loops meet themselves: at a sharp
/// corner two lines that lie next to their curves may cross before their ends.
/// @param reach_mm greatest length of a removed detour, without its first and last element
[[nodiscard]] Contour untangled(const Contour& contour, double reach_mm);

/// Returns whether elements of a contour meet anywhere except at the joints between neighbours.
/// Time: n log n if few elements are near each other.
[[nodiscard]] bool crosses_itself(const Contour& contour);

}  // namespace sim::surface
