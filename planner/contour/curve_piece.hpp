#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "planner/base/result.hpp"
#include "planner/contour/plane_curve.hpp"

namespace cnc::contour {

/// A place on a way, and which way it goes there.
struct WayPoint {
  WideVec2 place{0.0, 0.0};    ///< mm.
  WideVec2 tangent{1.0, 0.0};  ///< Unit vector.
};

/// A smooth part of a curve or of its offset: its tangent has no jump.
///
/// The offset is that of paper 1, eq. 3: C + d N with N the normal on the right,
/// outwards of an outline that runs counter-clockwise. It has the source's
/// tangents; where 1 + κ d, with κ positive to the left, is negative it runs
/// backwards, and there it lies within d of other places of the source: whoever
/// removes loops removes all of that.
struct CurvePiece {
  const PlaneCurve* curve = nullptr;  ///< Must outlive this.
  double offset_mm = 0.0;             ///< To the right; 0 for the curve itself.
  double from = 0.0;                  ///< Spans from the curve's start.
  double to = 0.0;                    ///< Greater than `from`.
  bool backwards = false;             ///< The offset runs against the source.

  /// @param spans `from`…`to`; at those ends the tangents of this piece.
  [[nodiscard]] WayPoint at(double spans) const;
};

enum class SplitError : std::uint8_t {
  kTooManyPieces,  ///< More than there is room for.
  kNoDirection,    ///< A span that is a point, or nearly.
};

inline constexpr double kCuspShare = 1.0e-13;
inline constexpr double kLeastCorner = 1.0e-6;

/// Divides the offset of a curve where its tangent jumps: at corners and cusps of the
/// source, and where κ d = −1, so that the offset has a cusp. Each cusp is found to
/// kCuspShare of a span.
///
/// Each span is looked at in kLooks places, between which a pair of cusps is found
/// only where 1 + κ d has its least or greatest value near one of them: two
/// that are nearer to each other than a hundredth of a span or so may stay in.
/// @param least_corner Radians; a smaller change of direction between spans is none, and
/// a fit goes round it within its tolerance. More than kLeastCorner for no offset only: an
/// offset has a gap there.
/// @param pieces room for them. @return how many there are.
[[nodiscard]] Result<std::size_t, SplitError> split_offset(const PlaneCurve& curve,
                                                           double offset_mm,
                                                           std::span<CurvePiece> pieces,
                                                           double least_corner = kLeastCorner);

}  // namespace cnc::contour
