#pragma once

#include <vector>

#include "host-sim/measure/curve.hpp"

namespace sim {

/// A G2 or G3 as programmed, in machine coordinates. The radius at the start
/// and at the end may differ: programs carry rounded decimals.
struct ProgrammedArc {
  Point start{};
  Point end{};
  cnc::Plane plane = cnc::Plane::kXY;
  std::array<double, 2> centre{};  ///< In the order of axes_of(plane).
  bool clockwise = false;          ///< G2.
  int turns = 1;                   ///< P: 1 is up to one full circle.
};

/// The radius at the start, mm.
[[nodiscard]] double start_radius(const ProgrammedArc& arc);

/// Start and end are one place in the plane, to half a nanometre.
[[nodiscard]] bool is_closed(const ProgrammedArc& arc);

/// Signed angle about the programmed centre, radians. Start and end at the same
/// place in the plane, or in the same direction from the centre, make a full circle, and so
/// does an end within a micrometre of the start and a turn of 5e-7 (cnc::CentreArc).
[[nodiscard]] double sweep_of(const ProgrammedArc& arc);

/// The exact curve of the arc: equal angles of at most half a turn. Inner points
/// of division lie at a radius that goes linearly with the angle from that of the
/// start to that of the end; each piece keeps its end points and moves its centre
/// (Curve::arc).
[[nodiscard]] std::vector<Curve> pieces_of(const ProgrammedArc& arc);

/// The centre of an arc given by its radius (RS274/NGC 3.5.3.1): positive for at
/// most half a turn, negative for more. A chord longer than 2|R| by rounding
/// takes its middle as the centre. Owed: start and end differ in the plane.
[[nodiscard]] std::array<double, 2> centre_from_radius(const ProgrammedArc& arc, double radius);

}  // namespace sim
