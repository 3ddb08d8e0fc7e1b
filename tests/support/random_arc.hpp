#pragma once

#include "host-sim/measure/programmed_path.hpp"
#include "planner/geometry/arc_elements.hpp"
#include "tests/support/random_machine.hpp"
#include "tests/support/random_program.hpp"

namespace proof {

/// How far a pulse may be from the exact arc, in mm beyond half a step.
inline constexpr double kArcPromise = 1.0e-3;

/// An arc, circle or helix twice: as the controller gets it, and as the
/// simulator's own double-precision reading has it.
struct TestArc {
  cnc::CentreArc arc{};
  sim::ProgrammedPath exact{};
  double radius = 0.0;  ///< mm.
  double sweep = 0.0;   ///< Radians, positive.

  /// One element for each half turn begun.
  [[nodiscard]] std::size_t elements() const;
  [[nodiscard]] Program program(double feed_mm_s) const;
};

/// R 0.05…2000 mm, all planes, tiny sweeps to five turns, exact half turns and
/// full circles among them, flat or rising, on 4 to 6 decimals.
[[nodiscard]] TestArc random_arc(Random& random);

/// A machine on which this arc takes about `steps` steps.
[[nodiscard]] TestMachine machine_for(Random& random, const TestArc& arc, double steps);

[[nodiscard]] sim::ProgrammedPath exact_path(const cnc::CentreArc& arc);

}  // namespace proof
