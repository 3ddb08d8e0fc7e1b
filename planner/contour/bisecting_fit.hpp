#pragma once

#include <cstddef>
#include <span>

#include "planner/contour/biarc_gauge.hpp"
#include "planner/contour/contour.hpp"
#include "planner/contour/curve_samples.hpp"
#include "planner/contour/least_value.hpp"

namespace cnc::contour {

/// Searches for the biarc from end to end of a polygon, with the tangents at its ends, that is
/// nearest to the polygon (Park, CAD&A 1 (2004) 187). Returns the biarc's joint share and its
/// greatest distance from the polygon, mm. The search ends early at the first biarc within
/// `enough_mm`.
[[nodiscard]] LeastValue optimal_biarc(std::span<const CurveSample> polygon, double enough_mm);

/// Result of the bisecting fit of paper 1.
struct BisectingResult {
  /// Number of arcs; 0 if even a biarc over a single edge of the polygon is too far from the curve.
  std::size_t arcs = 0;
  bool out_of_room = false;
};

/// Limits of the arc spline of paper 1, 4.2.1. One optimal biarc within `biarc_mm` replaces a
/// stretch of a base polygon. If there is no such biarc, or if the curve itself is farther from the
/// biarc than the tolerance, the stretch is halved at its middle corner.
struct BisectingLimits {
  double biarc_mm = 0.008;
  double tolerance_mm = 0.01;
};
[[nodiscard]] BisectingResult bisecting_fit(const CurvePiece& piece,
                                            std::span<const CurveSample> polygon,
                                            const BisectingLimits& limits,
                                            std::span<Vertex<double>> vertices);

}  // namespace cnc::contour
