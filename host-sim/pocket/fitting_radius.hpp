#pragma once

#include "host-sim/contour/contour_offset.hpp"

namespace sim::pocket {

/// A slot may be narrower than the tool by this, mm: drawn as wide as the tool, it is rounded.
inline constexpr double kSlotSlackMm = 1.0e-3;

/// Returns the radius with which a tool fits into a pocket: its own; half the slack less, which is
/// what the walls lose, where all of the pocket or an arm of it, longer than the tool's radius, is
/// a slot as wide as the tool, within the slack; 0 where the tool fits nowhere.
[[nodiscard]] double fitting_radius(const cnc::contour::ContourView<double>& pocket,
                                    double tool_radius_mm,
                                    ContourOffset& offsetter);

}  // namespace sim::pocket
