#pragma once

#include "planner/base/coordinate.hpp"
#include "planner/geometry/spline.hpp"

namespace cnc::gcode {

/// Memory for the points of a spline. A NURBS is collected over many lines, other splines within
/// one line. While no NURBS is open, the content belongs to the last kSpline action and is valid
/// until the next line.
struct SplineStore {
  Spline spline{};
  Position start{};  ///< Position of the first control point, machine coordinates.
};

}  // namespace cnc::gcode
