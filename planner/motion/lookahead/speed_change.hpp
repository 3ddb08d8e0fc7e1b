#pragma once

#include <cstdint>

namespace cnc::motion {

/// Which end of a span is known, and which way the speed is to change.
enum class Travel : std::int8_t { kForward = 1, kBackward = -1 };
enum class Change : std::int8_t { kSpeedUp = 1, kSlowDown = -1 };

/// A change of speed from a place where the speed is known to another one within the same span.
struct SpeedChange {
  float distance = 0.0F;      ///< mm, in the direction of `travel`.
  float speed_square = 0.0F;  ///< v² where it is known.
  float cap_square = 0.0F;    ///< The greatest v² on the way.
  Travel travel = Travel::kForward;
  Change change = Change::kSpeedUp;
  /// mm over which v² is assumed to grow when the jerk of turning is limited.
  float growing = 0.0F;
};

}  // namespace cnc::motion
