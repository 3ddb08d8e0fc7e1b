#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "planner/base/result.hpp"
#include "planner/contour/plane_curve.hpp"

namespace cnc::contour {

/// A point of a path, and the direction of the path at that point.
struct WayPoint {
  WideVec2 place{0.0, 0.0};    ///< mm.
  WideVec2 tangent{1.0, 0.0};  ///< Unit vector.
};

/// A smooth part of a curve or of its offset: the tangent of a piece has no jump.
///
/// The offset is that of paper 1, eq. 3: C + d N. N is the normal on the right, which points
/// outwards on an outline that runs counter-clockwise. The offset has the tangents of the source.
/// Where 1 + κ d is negative (κ positive to the left), the offset runs backwards. Such a part is
/// within d of other points of the source, so the removal of loops must remove all of it.
struct CurvePiece {
  const PlaneCurve* curve = nullptr;  ///< Source curve, which must outlive the piece.
  double offset_mm = 0.0;             ///< Offset to the right, mm; 0 for the curve itself.
  double from = 0.0;                  ///< Start parameter, counted in spans from the curve's start.
  double to = 0.0;                    ///< End parameter in spans; greater than `from`.
  /// Whether the offset runs opposite to the direction of the source.
  bool backwards = false;

  /// Returns the point and the direction at a parameter.
  /// @param spans parameter between `from` and `to`; at these two ends the tangent is that of this
  ///     piece.
  [[nodiscard]] WayPoint at(double spans) const;
};

enum class SplitError : std::uint8_t {
  kTooManyPieces,  ///< The curve has more pieces than `pieces` holds.
  kNoDirection,    ///< A span is a point or nearly a point.
};

inline constexpr double kCuspShare = 1.0e-13;
inline constexpr double kMinCorner = 1.0e-6;

/// Divides the offset of a curve at the points where its tangent jumps. These are corners and cusps
/// of the source, and points where κ d = −1 and the offset has a cusp. Each cusp is found to
/// kCuspShare of a span.
///
/// Each span is sampled at kLooks points. A pair of cusps between two samples is found only if 1 +
/// κ d has its least or greatest value near one of the samples. A pair that is closer together than
/// about a hundredth of a span may be missed.
/// @param min_corner least change of direction between spans that counts as a corner, radians. A
///     fit goes around a smaller change within its tolerance. It may exceed kMinCorner only if the
///     offset is 0, because an offset has a gap at each corner.
/// @param pieces storage for the pieces.
/// @return the number of pieces.
[[nodiscard]] Result<std::size_t, SplitError> split_offset(const PlaneCurve& curve,
                                                           double offset_mm,
                                                           std::span<CurvePiece> pieces,
                                                           double min_corner = kMinCorner);

}  // namespace cnc::contour
