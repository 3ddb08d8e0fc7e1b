#pragma once

#include <cstddef>
#include <iosfwd>

#include "tests/support/random_machine.hpp"
#include "tests/support/recorded_plan.hpp"

namespace proof {

/// The greatest of many figures, and where it was.
struct Greatest {
  double value = 0.0;
  std::size_t slice = 0;
  std::size_t axis = 0;

  void note(double candidate, std::size_t at_slice, std::size_t at_axis = 0) {
    if (!(candidate > value)) return;  // Keeps no NaN: is_finite() of the plan is checked apart.
    *this = {candidate, at_slice, at_axis};
  }
};

/// How near a plan came to each of its limits; 1 is at the limit.
struct PlanFigures {
  Greatest rate;           ///< Axis speed / limit, motor and combined step rates included.
  Greatest acceleration;   ///< |tangent · a + bend · v²| / limit, per axis.
  Greatest speed_change;   ///< Δ(axis speed) in 50 µs / limit, within a block.
  Greatest feed;           ///< Path speed / programmed feed.
  Greatest centripetal;    ///< What an axis has of v²/R / its limit.
  Greatest joint;          ///< Turn at a joint without a stop / what rounding may make of none.
  Greatest speed_jump;     ///< From slice to slice, mm/s.
  Greatest way_error;      ///< Way by speed − way by fraction, mm.
  Greatest end_speed;      ///< At rest before a stop and at the end, mm/s.
  bool contiguous = true;  ///< Slices cover every block from 0 to 1, in order.
  bool finite = true;
};

enum class Sampling { kAt20kHz, kAtSlicesOnly };

/// Evaluates the continuous plan at both ends of every slice and, unless told
/// otherwise, at 20 kHz, in double precision from the exact geometry.
[[nodiscard]] PlanFigures check_plan(const RecordedPlan& plan,
                                     const TestMachine& machine,
                                     Sampling sampling = Sampling::kAt20kHz);

/// Radians between two unit vectors.
[[nodiscard]] double turn_between(const Vector& before, const Vector& after);

}  // namespace proof
