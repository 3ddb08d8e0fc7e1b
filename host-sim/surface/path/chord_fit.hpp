#pragma once

#include <vector>

#include "host-sim/contour/contour_offset.hpp"
#include "host-sim/surface/path/slice_curve.hpp"

namespace sim::surface {

/// Appends few lines within a tolerance of some spans of a curve, from start to end. Each begins
/// where the one before still is within the tolerance and the line itself gets farthest, so that
/// their joints are beside the curve: on a bend they are half again as long as chords with both
/// ends on it. @param tolerance_mm above 0
void fit_chords(const cnc::contour::PlaneCurve& curve,
                const SpanRange& spans,
                double tolerance_mm,
                std::vector<ContourVertex>& out);

}  // namespace sim::surface
