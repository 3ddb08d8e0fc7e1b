#pragma once

#include "planner/motion/block/block.hpp"
#include "planner/motion/lookahead/speed_change.hpp"

namespace cnc::motion {

/// Limit zones of neighbouring blocks that reach into a block, under a time window.
class NeighbourZones {
 public:
  /// Copies the limit zones that reach into a block.
  void take(const Block& block) {
    head_ = block.head;
    tail_ = block.tail;
  }

  [[nodiscard]] const BlockZones& head() const { return head_; }
  [[nodiscard]] const BlockZones& tail() const { return tail_; }
  /// Returns the strictest limits of all limit zones that reach into the part of the block between
  /// two positions.
  /// @param from, to distances of these positions from the start of the block, mm
  /// @param length length of the block, mm
  [[nodiscard]] LimitZone between(float from, float to, float length) const;

 private:
  BlockZones head_{};
  BlockZones tail_{};
};

/// Returns the greatest acceleration ≤ `most` mm/s² that a limit zone allows for a change of speed.
/// @param window_s length of the time window in s, above 0
[[nodiscard]] float steepest_in(const LimitZone& zone,
                                float most,
                                const SpeedChange& change,
                                float window_s);

}  // namespace cnc::motion
