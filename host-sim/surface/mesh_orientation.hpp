#pragma once

#include "host-sim/surface/mesh.hpp"

namespace sim::surface {

/// Returns whether a mesh is inside out: no facet of it faces +Z and some face -Z, or it is closed
/// and its volume is negative. It counts as closed if its projected areas to both sides agree to a
/// billionth along every axis.
[[nodiscard]] bool is_inside_out(const Mesh& mesh);

}  // namespace sim::surface
