#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <cstdint>
#include <variant>
#include <vector>

#include "host-sim/contour/contour_offset.hpp"
#include "host-sim/surface/path/slice.hpp"

namespace sim::surface {

enum class StretchUse : std::uint8_t {
  kRow,   ///< Cuts, beside its neighbours.
  kSlot,  ///< Cuts with stock on both sides, as the first row of a layer.
  kLink,  ///< Leads over the surface from one row to the next.
};

/// The plane in which a tip stays at one height.
struct LevelPlane {
  double height_mm = 0.0;
};

/// A plane that holds a stretch: an upright one, or a level one.
using StretchPlane = std::variant<Slice, LevelPlane>;

/// Lines and arcs of a tool's tip in one plane. A vertex in a slice has the way along it as x and
/// the height as y; in a level plane X and Y. The last vertex is the end.
struct SurfaceStretch {
  StretchPlane plane;
  StretchUse use = StretchUse::kRow;
  std::vector<ContourVertex> vertices;

  /// Returns where the tip is at a vertex.
  [[nodiscard]] Eigen::Vector3d place_of(const ContourVertex& vertex) const {
    if (const auto* level = std::get_if<LevelPlane>(&plane)) {
      return {vertex.x, vertex.y, level->height_mm};
    }
    const Eigen::Vector2d seen = std::get<Slice>(plane).at(vertex.x);
    return {seen.x(), seen.y(), vertex.y};
  }
  [[nodiscard]] Eigen::Vector3d start() const { return place_of(vertices.front()); }
  [[nodiscard]] Eigen::Vector3d end() const { return place_of(vertices.back()); }
};

/// Stretches that are driven without a lift between them.
struct SurfaceRun {
  std::size_t end = 0;    ///< Number of the stretch behind its last one.
  double stock_mm = 0.0;  ///< Up to where stock may stand over its start.
};

/// Stretches in the order in which they are driven, mm.
struct SurfacePath {
  std::vector<SurfaceStretch> stretches;
  std::vector<SurfaceRun> runs;
  /// Stretches that no arcs fit, which are lines.
  std::size_t without_arcs = 0;
};

}  // namespace sim::surface
