#pragma once

#include "host-sim/contour/contour_offset.hpp"

namespace sim::surface {

/// Returns a contour without short detours at which a loop intersects itself. They occur at sharp
/// corners: two lines that approximate curves may cross before their ends.
/// @param reach_mm greatest length of a removed detour, excluding its first and its last element
[[nodiscard]] Contour untangled(const Contour& contour, double reach_mm);

/// Returns whether elements of a contour intersect or touch anywhere except at joints. The time for
/// n elements is proportional to n log n if few elements are near each other.
[[nodiscard]] bool crosses_itself(const Contour& contour);

}  // namespace sim::surface
