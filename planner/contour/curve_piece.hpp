#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "planner/base/result.hpp"
#include "planner/contour/plane_curve.hpp"

namespace cnc::contour {

/// A point of a path and the direction of the path there.
struct WayPoint {
  WideVec2 place{0.0, 0.0};    ///< mm.
  WideVec2 tangent{1.0, 0.0};  ///< Unit vector.
};

/// A smooth part of a curve or of its offset: the tangent of a piece has no jump.
///
/// The offset is that of paper 1, eq. 3: C + d N, with N the normal on the right, which points
/// outwards of an outline that runs counter-clockwise. The offset has the source's tangents. Where
/// 1 + κ d is negative (κ positive to the left), the offset runs backwards. There it lies within d
/// of other points of the source, so the removal of loops must remove all of it.
struct CurvePiece {
  const PlaneCurve* curve = nullptr;  ///< The curve must outlive the piece.
  double offset_mm = 0.0;             ///< To the right; 0 for the curve itself.
  double from = 0.0;                  ///< Counted in spans from the curve's start.
  double to = 0.0;                    ///< In spans; greater than `from`.
  /// Whether the offset runs against the direction of the source.
  bool backwards = false;

  /// Returns the point and the direction at a parameter.
  /// @param spans between `from` and `to`; at these two ends the tangent is that of this piece.
  [[nodiscard]] WayPoint at(double spans) const;
};

enum class SplitError : std::uint8_t {
  kTooManyPieces,  ///< The curve has more pieces than `pieces` holds.
  kNoDirection,    ///< A span is a point, or nearly one.
};

inline constexpr double kCuspShare = 1.0e-13;
inline constexpr double kMinCorner = 1.0e-6;

/// Divides the offset of a curve where its tangent jumps. That is at corners and cusps of the
/// source, and where κ d = −1, so that the offset has a cusp. Each cusp is found to kCuspShare of a
/// span.
///
/// Each span is sampled at kLooks points. Between two samples, a pair of cusps is found only where
/// 1 + κ d has its least or greatest value near one of them. A pair that is closer together than
/// about a hundredth of a span may be missed.
/// @param min_corner radians; a smaller change of direction between spans is not a corner, and a
/// fit goes around it within its tolerance. It may exceed kMinCorner only where the offset is 0:
/// an offset has a gap at each corner.
/// @param pieces storage for the pieces. @return the number of pieces.
[[nodiscard]] Result<std::size_t, SplitError> split_offset(const PlaneCurve& curve,
                                                           double offset_mm,
                                                           std::span<CurvePiece> pieces,
                                                           double min_corner = kMinCorner);

}  // namespace cnc::contour
