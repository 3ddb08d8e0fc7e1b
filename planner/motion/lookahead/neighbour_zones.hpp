#pragma once

#include "planner/motion/block/block.hpp"
#include "planner/motion/lookahead/speed_change.hpp"

namespace cnc::motion {

/// Zones of a block's neighbours that reach into it, under a time window.
class NeighbourZones {
 public:
  /// Takes the zones that reach into a block.
  void take(const Block& block) {
    head_ = block.head;
    tail_ = block.tail;
  }

  [[nodiscard]] const BlockZones& head() const { return head_; }
  [[nodiscard]] const BlockZones& tail() const { return tail_; }
  /// Returns the limits that all zones together set between two distances from the start of the
  /// block.
  /// @param from, to the distances in mm
  /// @param length of the block in mm
  [[nodiscard]] LimitZone between(float from, float to, float length) const;

 private:
  BlockZones head_{};
  BlockZones tail_{};
};

/// Returns the greatest acceleration ≤ `most` mm/s² within a zone. @param window_s above 0
[[nodiscard]] float steepest_in(const LimitZone& zone,
                                float most,
                                const SpeedChange& change,
                                float window_s);

}  // namespace cnc::motion
