#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "host-sim/surface/mesh.hpp"
#include "host-sim/surface/read_surface.hpp"

namespace sim::surface {

/// A mesh as it stands in a file, in the file's unit, before it is checked.
struct MeshDraft {
  std::string name;  ///< Name of the file, for messages.
  Mesh mesh{};
  /// Number of each facet in the file, from 1; empty if they are those of the mesh. A polygon of
  /// the file is several facets.
  std::vector<std::uint32_t> numbers{};
  std::vector<std::string> notes{};

  [[nodiscard]] std::size_t number(std::size_t facet) const {
    return numbers.empty() ? facet + 1 : numbers[facet];
  }
};

/// Scales and checks a mesh, drops degenerate facets and unused points, and turns over a mesh that
/// is inside out. Throws std::invalid_argument where an index is out of range, a coordinate is not
/// finite or beyond kFarthestMm, or no facet is left.
[[nodiscard]] SurfaceInput finished_mesh(MeshDraft draft, const ReadOptions& options);

}  // namespace sim::surface
