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
  kRow,   ///< The tool cuts next to neighbouring rows.
  kSlot,  ///< The tool cuts with stock on both sides, as in the first row of a layer.
  kLink,  ///< The tool moves over the surface from one row to the next.
};

/// A level plane in which the tip moves at a constant height.
struct LevelPlane {
  double height_mm = 0.0;
};

/// Plane of a stretch: vertical (a slice) or level.
using StretchPlane = std::variant<Slice, LevelPlane>;

/// Lines and arcs of a tool's tip in one plane. In a slice, x of a vertex is the distance along the
/// slice and y is the height. In a level plane, x and y are X and Y. The last vertex is the end.
struct SurfaceStretch {
  StretchPlane plane;
  StretchUse use = StretchUse::kRow;
  std::vector<ContourVertex> vertices;

  /// Returns the position of the tip at `vertex`.
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

/// Successive stretches that are driven without a lift between them.
struct SurfaceRun {
  std::size_t end = 0;    ///< Index after the last stretch of the run.
  double stock_mm = 0.0;  ///< Greatest height of the stock's top over the run's start.
};

/// A path over a surface, mm: stretches in the order of driving, and runs.
struct SurfacePath {
  std::vector<SurfaceStretch> stretches;
  std::vector<SurfaceRun> runs;
  /// Number of pieces that became lines because no arcs are within the tolerance.
  std::size_t without_arcs = 0;
};

}  // namespace sim::surface
