#pragma once

#include "planner/contour/curve.hpp"
#include "planner/contour/curve_piece.hpp"

namespace cnc::contour {

/// The arc that leaves `start` along `tangent`, a unit vector, and ends at `end`; a line where the
/// two are one place.
[[nodiscard]] Curve<double> arc_leaving(const WideVec2& start,
                                        const WideVec2& tangent,
                                        const WideVec2& end);

/// A part of a piece: spans, `from` at most `to`.
struct CurveStretch {
  const CurvePiece* piece = nullptr;
  double from = 0.0;
  double to = 0.0;
};

/// How far an arc and the stretch of a curve beside it are from each other, both ways, mm; a
/// bound, at most `fine_mm` or so above what it is. kNoArcFits where nothing can be said.
///
/// The stretch: places of it are looked at so near to each other that what the distance
/// may rise to between two, by how fast it grows at both, is within `fine_mm`. The arc itself
/// counts, not its circle: a curve that goes back beside it is measured to its ends.
///
/// The arc: as long as the curve is nearer to it than its radius, the place of the arc that is
/// nearest goes on without a jump as the curve does, and so passes every place between those
/// nearest to the stretch's ends. What of the arc is left out is nearer to these than the arc's
/// ends are, whose distance from them counts too.
[[nodiscard]] double arc_deviation(const CurveStretch& stretch,
                                   const Curve<double>& arc,
                                   double fine_mm);
inline constexpr double kNoArcFits = 1.0e9;

}  // namespace cnc::contour
