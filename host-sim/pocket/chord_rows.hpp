#pragma once

#include <cstdint>
#include <vector>

#include "planner/geometry/vector.hpp"
#include "planner/pocket/area_distance.hpp"

namespace sim::pocket {

/// A point of a grid with integer coordinates.
struct GridPoint {
  std::int32_t x = 0;
  std::int32_t y = 0;
  bool operator==(const GridPoint&) const = default;
};

/// A chord of an element of an area, or a piece of a tangent of the element.
struct Chord {
  GridPoint from;
  GridPoint to;
  std::uint32_t element = 0;
};

/// A boundary as chords between points of a grid, for algorithms that are exact for integers.
struct ChordRows {
  std::vector<Chord> chords;
  cnc::WideVec2 centre{0.0, 0.0};  ///< Position of the grid's origin, mm.
  double unit_mm = 1.0;            ///< Distance between points of the grid, mm; a power of 2.

  [[nodiscard]] cnc::WideVec2 place(double x, double y) const {
    return centre + unit_mm * cnc::WideVec2{x, y};
  }
};

/// Grid coordinates are within ±2^29, so that cross products of differences fit into 64 bits.
inline constexpr double kGridReach = 536870912.0;

/// Returns the boundary of an area as chords that are within `sagitta_mm` of it. Where chords would
/// cross each other, finer chords are used. An arc whose centre is on the side of the area is
/// divided into tangents, any other arc into chords.
///
/// Throws std::runtime_error with the point where elements still cross at about a hundredth of the
/// sagitta.
[[nodiscard]] ChordRows chords_of(const cnc::pocket::AreaDistance& area, double sagitta_mm);

}  // namespace sim::pocket
