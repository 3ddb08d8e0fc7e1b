#pragma once

#include <cstddef>
#include <span>

#include "planner/contour/curve_piece.hpp"

namespace cnc::contour {

/// One of the places at which a fit looks at a curve.
struct CurveSample {
  WayPoint point{};
  double spans = 0.0;   ///< As CurvePiece counts.
  double turned = 0.0;  ///< Radians, from the start on, always counted positive.
};

/// How near samples are to each other.
struct SampleDensity {
  double sagitta_mm = 0.01;  ///< Between the curve and its chord, at most.
  double bend_mm = 0.001;    ///< Between the curve and an arc, at most about.
};

/// Places along a piece, from its start to its end, as near to each other as `density`
/// asks for.
/// @param room for them.
/// @return how many; 0 when that is more than there is room for, 1 where the curve jumps, as
/// far as the digits of its parameter tell.
[[nodiscard]] std::size_t sample_curve(const CurvePiece& piece,
                                       const SampleDensity& density,
                                       std::span<CurveSample> room);

}  // namespace cnc::contour
