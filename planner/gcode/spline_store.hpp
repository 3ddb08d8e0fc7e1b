#pragma once

#include "planner/base/coordinate.hpp"
#include "planner/geometry/spline.hpp"

namespace cnc::gcode {

/// Where a spline is put together: a NURBS over many lines, the others within
/// one. While no NURBS is open its content means something to the last
/// kSpline action only, and that until the next line.
struct SplineStore {
  Spline spline{};
  Position start{};  ///< Machine coordinates, of the first control point.
};

}  // namespace cnc::gcode
