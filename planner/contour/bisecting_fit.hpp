#pragma once

#include <cstddef>
#include <span>

#include "planner/contour/biarc_gauge.hpp"
#include "planner/contour/contour.hpp"
#include "planner/contour/curve_samples.hpp"
#include "planner/contour/least_value.hpp"

namespace cnc::contour {

/// The biarc between both ends of a polygon, with their tangents, that stays nearest to it
/// (Park, CAD&A 1 (2004) 187): its joint share and the greatest distance, mm.
[[nodiscard]] LeastValue optimal_biarc(std::span<const CurveSample> polygon, double enough_mm);

/// What the bisecting of paper 1 came to.
struct BisectingResult {
  std::size_t arcs = 0;  ///< 0 where no polygon edge, or too few arcs.
  bool out_of_room = false;
};

/// The arc spline of paper 1, 4.2.1: the stretches of a base polygon that one optimal biarc
/// replaces within `biarc_mm`; where none does, or the curve itself shows to be farther than the
/// tolerance, the stretch is halved at its middle corner.
struct BisectingLimits {
  double biarc_mm = 0.008;
  double tolerance_mm = 0.01;
};
[[nodiscard]] BisectingResult bisecting_fit(const CurvePiece& piece,
                                            std::span<const CurveSample> polygon,
                                            const BisectingLimits& limits,
                                            std::span<Vertex<double>> vertices);

}  // namespace cnc::contour
