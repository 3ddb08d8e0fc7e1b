#pragma once

#include <algorithm>

#include "planner/gcode/modal_state.hpp"
#include "planner/geometry/arc_fit.hpp"
#include "planner/path/path_item.hpp"

namespace cnc {

/// Tolerances that hold if the program gives no tolerance, mm.
struct UsualTolerance {
  float path_mm = 0.01F;  ///< Tolerance of corners and welds together ($11).
  float arc_mm = 0.002F;  ///< Tolerance of arcs that replace a curve or short lines ($12).
};

/// Returns the tolerances of the driven path. G61.1 allows none. G61, and G64 without P and Q, keep
/// corners and welds together within the usual tolerance. With P, corners are rounded within P and
/// short lines are welded within Q; P without Q is the tolerance for both.
[[nodiscard]] inline path::Tolerance path_tolerance(const gcode::PathControl& control,
                                                    const UsualTolerance& usual) {
  if (control.mode == gcode::PathMode::kStop) return {};
  if (!control.tolerance_mm && !control.naive_tolerance_mm) {
    return path::tolerance_within(usual.path_mm, usual.arc_mm);
  }
  return {.corner_mm = control.tolerance_mm.value_or(usual.path_mm),
          .weld_mm = control.naive_tolerance_mm.value_or(control.tolerance_mm.value_or(0.0F))};
}

/// Returns the greatest distance of arcs from the spline that they replace, mm: Q of G64, or the
/// usual tolerance of arcs.
[[nodiscard]] inline float spline_tolerance(const gcode::PathControl& control,
                                            const UsualTolerance& usual) {
  const float naive = control.naive_tolerance_mm.value_or(0.0F);
  return std::max(naive > 0.0F ? naive : usual.arc_mm, ArcFit::kMinToleranceMm);
}

}  // namespace cnc
