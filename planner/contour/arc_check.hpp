#pragma once

#include "planner/contour/curve.hpp"
#include "planner/contour/curve_piece.hpp"

namespace cnc::contour {

/// Returns the arc that leaves `start` along `tangent`, a unit vector, and ends at `end`. Returns a
/// line if `start` and `end` are one point.
[[nodiscard]] Curve<double> arc_leaving(const WideVec2& start,
                                        const WideVec2& tangent,
                                        const WideVec2& end);

/// A part of a piece of a curve. `from` and `to` are parameters counted in spans, as in CurvePiece;
/// `from` is at most `to`.
struct CurveStretch {
  const CurvePiece* piece = nullptr;
  double from = 0.0;
  double to = 0.0;
};

/// Returns an upper bound of the distance between an arc and the stretch of a curve that the arc
/// replaces, mm. The distance counts both ways: from the stretch to the arc and from the arc to the
/// stretch. The bound exceeds the true value by about `fine_mm` at most. Returns kNoArcFits if no
/// bound can be given.
///
/// From the stretch to the arc: points of the stretch are checked. They are so close together that
/// between two of them the distance rises by at most `fine_mm`; the slopes of the distance at both
/// points prove this. The distance is measured to the arc itself and not to its circle: for a point
/// of the curve beyond an end of the arc, the distance from this end counts.
///
/// From the arc to the stretch: while a point moves along the curve, the nearest point of the arc
/// moves along the arc. It moves without a jump as long as the distance is less than the arc's
/// radius. So it passes every point of the arc between the two points nearest to the stretch's
/// ends. Each remaining point of the arc is nearer to an end of the stretch than the arc's end at
/// that side is. Therefore the distances of the arc's ends from the stretch's ends count, too.
[[nodiscard]] double arc_deviation(const CurveStretch& stretch,
                                   const Curve<double>& arc,
                                   double fine_mm);
inline constexpr double kNoArcFits = 1.0e9;

}  // namespace cnc::contour
