#pragma once

#include <cstddef>
#include <iosfwd>

#include "tests/support/random_machine.hpp"
#include "tests/support/recorded_plan.hpp"

namespace proof {

/// Greatest value of a figure, and where it occurs.
struct Greatest {
  double value = 0.0;
  std::size_t slice = 0;
  std::size_t axis = 0;

  void note(double candidate, std::size_t at_slice, std::size_t at_axis = 0) {
    // Never stores NaN: is_finite() of the plan is checked separately.
    if (!(candidate > value)) return;
    *this = {candidate, at_slice, at_axis};
  }
};

/// Greatest values of a plan in relation to its limits; 1 is at the limit.
struct PlanFigures {
  Greatest rate;           ///< Axis speed / limit, including motor and combined step rates.
  Greatest acceleration;   ///< |tangent · a + bend · v²| / limit, per axis.
  Greatest speed_change;   ///< Change of axis speed in 50 µs / limit, within a block.
  Greatest feed;           ///< Path speed / programmed feed.
  Greatest centripetal;    ///< Part of v²/R on an axis / its limit.
  Greatest joint;          ///< Turn at a joint without a stop / greatest turn by rounding.
  Greatest speed_jump;     ///< Change of speed from slice to slice, mm/s.
  Greatest way_error;      ///< Distance by speed − distance by fraction, mm.
  Greatest end_speed;      ///< Speed before a stop and at the end, mm/s.
  bool contiguous = true;  ///< Whether slices cover every block from 0 to 1, in order.
  bool finite = true;
};

enum class Sampling { kAt20kHz, kAtSlicesOnly };

/// Evaluates the continuous plan at both ends of every slice, in double precision from the exact
/// geometry; by default also at 20 kHz.
[[nodiscard]] PlanFigures check_plan(const RecordedPlan& plan,
                                     const TestMachine& machine,
                                     Sampling sampling = Sampling::kAt20kHz);

/// Returns the angle between two unit vectors, radians.
[[nodiscard]] double turn_between(const Vector& before, const Vector& after);

}  // namespace proof
