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

/// Stretches in the order in which they are driven, mm.
struct SurfacePath {
  std::vector<SurfaceStretch> stretches;
  /// Behind these numbers of stretches the tool lifts; the last is their count.
  std::vector<std::size_t> run_ends;
  /// Stretches that no arcs fit, which are lines.
  std::size_t without_arcs = 0;
};

}  // namespace sim::surface
