#pragma once

#include <cstdint>

namespace cnc::motion {

/// `Travel` is the direction along the path, seen from the position where the speed is known.
/// `Change` is the direction in which the speed changes.
enum class Travel : std::int8_t { kForward = 1, kBackward = -1 };
enum class Change : std::int8_t { kSpeedUp = 1, kSlowDown = -1 };

/// A change of speed from a position where the speed is known to another position of the same span.
struct SpeedChange {
  float distance = 0.0F;      ///< Distance between the positions in the direction of `travel`, mm.
  float speed_square = 0.0F;  ///< v² at the position where the speed is known.
  float cap_square = 0.0F;    ///< Greatest v² during the change.
  Travel travel = Travel::kForward;
  Change change = Change::kSpeedUp;
  /// Distance, mm, over which v² is assumed to grow when the jerk limit is checked.
  float growing = 0.0F;
};

}  // namespace cnc::motion
