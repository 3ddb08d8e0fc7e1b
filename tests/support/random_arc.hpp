#pragma once

#include "host-sim/measure/programmed_path.hpp"
#include "planner/geometry/arc_elements.hpp"
#include "tests/support/random_machine.hpp"
#include "tests/support/random_program.hpp"

namespace proof {

/// Greatest distance of a pulse from the exact arc, in mm, in addition to half a step.
inline constexpr double kArcPromise = 1.0e-3;

/// An arc, circle or helix in two forms: as the controller receives it, and as the simulator's
/// reader computes it in double precision.
struct TestArc {
  cnc::CentreArc arc{};
  sim::ProgrammedPath exact{};
  double radius = 0.0;  ///< Radius, mm.
  double sweep = 0.0;   ///< Sweep, radians, positive.

  /// Returns the number of path elements: one for each half turn begun.
  [[nodiscard]] std::size_t elements() const;
  [[nodiscard]] Program program(double feed_mm_s) const;
};

/// Returns a random arc: radius 0.05…2000 mm, in all planes, with sweeps from tiny ones to five
/// turns, including exact half turns and full circles. It is flat or rising, on 4 to 6 decimals.
[[nodiscard]] TestArc random_arc(Random& random);

/// Returns a machine on which this arc takes about `steps` steps.
[[nodiscard]] TestMachine machine_for(Random& random, const TestArc& arc, double steps);

[[nodiscard]] sim::ProgrammedPath exact_path(const cnc::CentreArc& arc);

}  // namespace proof
