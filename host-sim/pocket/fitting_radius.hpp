#pragma once

#include "host-sim/contour/contour_offset.hpp"

namespace sim::pocket {

/// A slot that is drawn as wide as the tool may be narrower than the tool by this much, mm, by
/// rounding.
inline constexpr double kSlotSlackMm = 1.0e-3;

/// Returns the radius with which a tool fits into a pocket; 0 where the tool fits nowhere. Normally
/// it is the tool's own radius. It is less by half the slack if the whole pocket is a slot as wide
/// as the tool within the slack. An arm of the pocket that is longer than the tool's radius has the
/// same effect. The walls then lose half the slack.
[[nodiscard]] double fitting_radius(const cnc::contour::ContourView<double>& pocket,
                                    double tool_radius_mm,
                                    ContourOffset& offsetter);

}  // namespace sim::pocket
