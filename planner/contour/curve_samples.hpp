#pragma once

#include <cstddef>
#include <span>

#include "planner/contour/curve_piece.hpp"

namespace cnc::contour {

/// A point at which a fit samples a curve.
struct CurveSample {
  WayPoint point{};
  double spans = 0.0;  ///< Parameter of the point in spans, counted as in CurvePiece.
  /// Angle by which the curve has turned since its start, radians. Turns to either side count as
  /// positive.
  double turned = 0.0;
};

/// Limits that set the distance between samples.
struct SampleDensity {
  double sagitta_mm = 0.01;  ///< Greatest distance between the curve and its chord, mm.
  double bend_mm = 0.001;    ///< Approximate greatest distance between the curve and an arc, mm.
};

/// Samples a piece from its start to its end, as densely as `density` requires.
/// @param room storage for the samples.
/// @return the number of samples; 0 if `room` is too small; 1 if the curve jumps or turns too
///     sharply for the resolution of its parameter.
[[nodiscard]] std::size_t sample_curve(const CurvePiece& piece,
                                       const SampleDensity& density,
                                       std::span<CurveSample> room);

}  // namespace cnc::contour
