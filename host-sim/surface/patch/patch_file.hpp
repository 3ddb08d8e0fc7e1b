#pragma once

#include <string>

#include "host-sim/surface/patch/patch_surface.hpp"

namespace sim::surface::patch {

/// Returns the patches as text. A patch is a line `patch ID u0 u1 v0 v1` and 16 lines `x y z`. The
/// identifier counts from 0, and the rows and columns are exact numbers. The 16 lines are the
/// control points in mm with 17 digits, u outer and v inner. Patches share a border if its numbers
/// are equal.
[[nodiscard]] std::string patch_text(const PatchSurface& surface);

}  // namespace sim::surface::patch
