#pragma once

#include "planner/base/coordinate.hpp"
#include "planner/geometry/spline.hpp"

namespace cnc::gcode {

/// Memory in which a spline is assembled: a NURBS over many lines, other splines within one line.
/// While no NURBS is open, the content is used by the last kSpline action only, until the next
/// line.
struct SplineStore {
  Spline spline{};
  Position start{};  ///< Position of the first control point, machine coordinates.
};

}  // namespace cnc::gcode
