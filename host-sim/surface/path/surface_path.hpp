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

/// The level plane in which a tip stays at one height.
struct LevelPlane {
  double height_mm = 0.0;
};

/// The plane that contains a stretch: vertical (a slice) or level.
using StretchPlane = std::variant<Slice, LevelPlane>;

/// Lines and arcs of a tool's tip in one plane. In a slice a vertex has the distance along it as x
/// and the height as y; in a level plane a vertex has X and Y. The last vertex is the end.
struct SurfaceStretch {
  StretchPlane plane;
  StretchUse use = StretchUse::kRow;
  std::vector<ContourVertex> vertices;

  /// Returns the position of the tip at a vertex.
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
  std::size_t end = 0;    ///< Index after the last stretch of the run.
  double stock_mm = 0.0;  ///< Height up to which stock may stand over the run's start.
};

/// Stretches in the order in which they are driven, mm.
struct SurfacePath {
  std::vector<SurfaceStretch> stretches;
  std::vector<SurfaceRun> runs;
  /// Number of stretches that are lines because no arcs fit.
  std::size_t without_arcs = 0;
};

}  // namespace sim::surface
