#pragma once

#include <string>

#include "host-sim/surface/patch/patch_surface.hpp"

namespace sim::surface::patch {

/// Returns the patches as text. A patch is a line `patch ID u0 u1 v0 v1`, the identifier from 0 and
/// its rows and columns as exact numbers, and 16 lines `x y z` of its control points in mm with 17
/// digits, u outer and v inner. Patches share a border where these numbers are equal.
[[nodiscard]] std::string patch_text(const PatchSurface& surface);

}  // namespace sim::surface::patch
