#pragma once

#include <vector>

#include "host-sim/measure/curve.hpp"

namespace sim {

/// A G2 or G3 as programmed, in machine coordinates. The radius at the start and at the end may
/// differ, because programs contain rounded decimals.
struct ProgrammedArc {
  Point start{};
  Point end{};
  cnc::Plane plane = cnc::Plane::kXY;
  std::array<double, 2> centre{};  ///< Centre in the order of axes_of(plane).
  bool clockwise = false;          ///< Whether the arc is a G2.
  int turns = 1;                   ///< P: 1 means at most one full circle.
};

/// Returns the radius at the start, mm.
[[nodiscard]] double start_radius(const ProgrammedArc& arc);

/// Returns whether start and end are one point in the plane, to half a nanometre.
[[nodiscard]] bool is_closed(const ProgrammedArc& arc);

/// Returns the signed angle about the programmed centre, radians. Start and end make a full circle
/// if they are the same point in the plane or lie in the same direction from the centre. So does an
/// end within a micrometre of the start and a turn of 5e-7 (cnc::CentreArc).
[[nodiscard]] double sweep_of(const ProgrammedArc& arc);

/// Returns the exact curve of the arc as pieces of equal angles of at most half a turn. The radius
/// of the inner points of division changes linearly with the angle from that of the start to that
/// of the end. Each piece keeps its end points and moves its centre (Curve::arc).
[[nodiscard]] std::vector<Curve> pieces_of(const ProgrammedArc& arc);

/// Returns the centre of an arc given by its radius (RS274/NGC 3.5.3.1). A positive radius means at
/// most half a turn, a negative one more. If the chord is longer than 2|R| by rounding, its middle
/// is the centre.
/// @pre start and end differ in the plane
[[nodiscard]] std::array<double, 2> centre_from_radius(const ProgrammedArc& arc, double radius);

}  // namespace sim
