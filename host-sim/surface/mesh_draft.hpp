#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "host-sim/surface/mesh.hpp"
#include "host-sim/surface/read_surface.hpp"

namespace sim::surface {

/// A mesh as read from a file, in the file's unit, before checks.
struct MeshDraft {
  std::string name;  ///< Name of the file, for messages.
  Mesh mesh{};
  /// Number of each facet in the file, counted from 1. The facets of a polygon share its number.
  /// Empty if the file's facets are the mesh's facets.
  std::vector<std::uint32_t> numbers{};
  std::vector<std::string> notes{};

  [[nodiscard]] std::size_t number(std::size_t facet) const {
    return numbers.empty() ? facet + 1 : numbers[facet];
  }
};

/// Scales and checks a mesh, drops degenerate facets and unused points, and flips a mesh that is
/// inside out. Throws std::invalid_argument if an index is out of range, if a coordinate is not
/// finite or is beyond kFarthestMm, or if no facet is left.
[[nodiscard]] SurfaceInput finished_mesh(MeshDraft draft, const ReadOptions& options);

}  // namespace sim::surface
