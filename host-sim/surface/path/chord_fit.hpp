#pragma once

#include <vector>

#include "host-sim/contour/contour_offset.hpp"
#include "host-sim/surface/path/slice_curve.hpp"

namespace sim::surface {

/// Appends few lines that follow some spans of a curve within a tolerance, from the start of the
/// spans to their end. Each line begins on the previous line, at the point from which the new line
/// reaches farthest. The joints may thus be offset from the curve. On a bend, the lines are 1.5
/// times as long as chords with both ends on the curve.
/// @param tolerance_mm tolerance, above 0
void fit_chords(const cnc::contour::PlaneCurve& curve,
                const SpanRange& spans,
                double tolerance_mm,
                std::vector<ContourVertex>& out);

}  // namespace sim::surface
