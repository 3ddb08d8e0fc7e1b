#pragma once

#include <array>
#include <cstddef>

#include "planner/motion/block/block.hpp"

namespace cnc::motion {

/// Collects, along the path, the zones of blocks that were passed.
class ZoneTrail {
 public:
  void clear() { count_ = 0; }
  [[nodiscard]] bool empty() const { return count_ == 0; }
  /// Adds the zone of a block at its end, where the zone begins to reach into the neighbours.
  void add(const LimitZone& zone);
  /// Moves on by `length` mm. The plan drives this distance at most so fast that half a window is
  /// `reach` mm. Where the plan is slow, zones end after the time of a window.
  void advance(float length, float reach);
  /// Returns the zones that reach into a block whose own limits are `own`.
  [[nodiscard]] BlockZones reaching(const LimitZone& own) const;

 private:
  static constexpr std::size_t kCapacity = 3;

  struct Reaching {
    LimitZone zone{};
    float whole = 0.0F;  ///< Length of the zone at first, mm.
  };

  void remove(std::size_t index);
  void merge_cheapest();

  std::array<Reaching, kCapacity + 1> zones_{};
  std::size_t count_ = 0;
};

}  // namespace cnc::motion
