#pragma once

#include "host-sim/contour/contour_offset.hpp"

namespace sim::pocket {

/// Greatest amount by which rounding may make a slot narrower than the tool, mm, if the slot is
/// drawn as wide as the tool.
inline constexpr double kSlotSlackMm = 1.0e-3;

/// Returns the radius with which a tool fits into a pocket; 0 where the tool fits nowhere.
/// Normally, it is the tool's own radius. It is less by half of kSlotSlackMm if the pocket is a
/// slot as wide as the tool within kSlotSlackMm. An arm of the pocket that is such a slot, and
/// longer than the tool's radius, has the same effect. With the smaller radius, the tool cuts into
/// the walls by half of kSlotSlackMm.
[[nodiscard]] double fitting_radius(const cnc::contour::ContourView<double>& pocket,
                                    double tool_radius_mm,
                                    ContourOffset& offsetter);

}  // namespace sim::pocket
