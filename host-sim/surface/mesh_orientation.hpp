#pragma once

#include "host-sim/surface/mesh.hpp"

namespace sim::surface {

/// Returns whether a mesh is inside out. An open mesh is inside out if facets face -Z and none
/// faces +Z. A closed mesh is inside out if its volume is negative. A mesh counts as closed if,
/// along each axis, the projected areas of both directions agree to a billionth.
[[nodiscard]] bool is_inside_out(const Mesh& mesh);

}  // namespace sim::surface
