#pragma once

#include "planner/motion/path_units.hpp"

namespace cnc::motion {

/// Where on an arc an axis of its plane reverses: at each quarter turn of its
/// tangent. A straight block has none.
class Reversals {
 public:
  Reversals() = default;
  Reversals(const Block& block, PathUnits length);

  /// The first one behind `place`, or the end of the block.
  [[nodiscard]] PathUnits next_after(PathUnits place) const;
  /// Whether one is so near that the speed of an axis changes by more than
  /// itself soon: within a 96th of a turn.
  [[nodiscard]] bool near(PathUnits place) const;

 private:
  [[nodiscard]] float quarters_at(PathUnits place) const;
  [[nodiscard]] PathUnits place_of(float quarters) const;

  PathUnits length_ = 0;
  float start_ = 0.0F;  ///< Tangent at the start in quarter turns, mirrored so that it grows.
  float sweep_ = 0.0F;  ///< In quarter turns; 0 for a straight block.
};

}  // namespace cnc::motion
