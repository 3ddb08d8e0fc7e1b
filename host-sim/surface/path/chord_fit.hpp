#pragma once

#include <vector>

#include "host-sim/contour/contour_offset.hpp"
#include "host-sim/surface/path/slice_curve.hpp"

namespace sim::surface {

/// Appends lines within a tolerance of some spans of a curve, from start to end, and tries to use
/// few of them. Each line begins on the previous one, at a point still within the tolerance from
/// which the new line gets farthest. The joints thus lie next to the curve: on a bend the lines are
/// 1.5 times as long as chords with both ends on the curve.
/// @param tolerance_mm tolerance, above 0
void fit_chords(const cnc::contour::PlaneCurve& curve,
                const SpanRange& spans,
                double tolerance_mm,
                std::vector<ContourVertex>& out);

}  // namespace sim::surface
