#pragma once

#include "host-sim/surface/mesh.hpp"

namespace sim::surface {

/// Returns whether a mesh is inside out. It is inside out if no facet faces +Z and some face -Z, or
/// if it is closed and its volume is negative. It counts as closed if, along every axis, its
/// projected areas to both sides agree to a billionth.
[[nodiscard]] bool is_inside_out(const Mesh& mesh);

}  // namespace sim::surface
