#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "host-sim/contour/contour_offset.hpp"
#include "host-sim/surface/path/slice.hpp"

namespace sim::surface {

enum class StretchUse : std::uint8_t {
  kRow,   ///< Cuts, beside its neighbours.
  kLink,  ///< Leads over the surface from one row to the next.
};

/// The way of a tool's tip over one slice: lines and arcs in its upright plane. A vertex has the
/// way along the slice as x and the height as y; the last one is the end.
struct SurfaceStretch {
  Slice slice;
  StretchUse use = StretchUse::kRow;
  std::vector<ContourVertex> vertices;
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
