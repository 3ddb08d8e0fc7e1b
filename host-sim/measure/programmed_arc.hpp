#pragma once

#include <vector>

#include "host-sim/measure/curve.hpp"

namespace sim {

/// A G2 or G3 as programmed, in machine coordinates. The radii at the start and at the end may
/// differ, because programs contain rounded decimals.
struct ProgrammedArc {
  Point start{};
  Point end{};
  cnc::Plane plane = cnc::Plane::kXY;
  std::array<double, 2> centre{};  ///< Centre in the order of axes_of(plane), mm.
  bool clockwise = false;          ///< Whether the arc is a G2.
  int turns = 1;  ///< Number of turns, P of the program: 1 means at most one full circle.
};

/// Returns the radius at the start, mm.
[[nodiscard]] double start_radius(const ProgrammedArc& arc);

/// Returns whether start and end are one point in the plane, within half a nanometre.
[[nodiscard]] bool is_closed(const ProgrammedArc& arc);

/// Returns the signed angle of the arc about the programmed centre, radians. The arc is a full
/// circle if start and end are the same point in the plane, or are in the same direction from the
/// centre. It is also a full circle if the end is within a micrometre of the start and the angle
/// between both is at most 5e-7 radians (cnc::CentreArc).
[[nodiscard]] double sweep_of(const ProgrammedArc& arc);

/// Returns the exact curve of the arc as pieces of equal angles of at most half a turn. At the
/// division points, the radius changes linearly with the angle, from the radius of the start to the
/// radius of the end. Each piece keeps its end points and moves its centre (Curve::arc).
[[nodiscard]] std::vector<Curve> pieces_of(const ProgrammedArc& arc);

/// Returns the centre of an arc with a given radius (RS274/NGC 3.5.3.1). A positive radius means an
/// arc of at most half a turn, a negative radius an arc of more. If rounding makes the chord longer
/// than 2|R|, the middle of the chord is the centre.
/// @pre start and end differ in the plane
[[nodiscard]] std::array<double, 2> centre_from_radius(const ProgrammedArc& arc, double radius);

}  // namespace sim
