#pragma once

#include <string>

#include "host-sim/surface/patch/patch_surface.hpp"

namespace sim::surface::patch {

/// Returns the patches as text. A patch is a line `patch ID u0 u1 v0 v1` and 16 lines `x y z`. ID
/// counts from 0; u0 to u1 are rows and v0 to v1 are columns, without rounding. The 16 lines are
/// the control points in mm with 17 digits; the index for v changes fastest. Two patches share a
/// border if they have the same numbers there.
[[nodiscard]] std::string patch_text(const PatchSurface& surface);

}  // namespace sim::surface::patch
