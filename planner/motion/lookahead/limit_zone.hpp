#pragma once

#include <array>
#include <cstddef>

#include "planner/motion/block/block.hpp"

namespace cnc::motion {

/// Collects the limit zones of blocks while a pass of the look-ahead moves along the path.
class ZoneTrail {
 public:
  void clear() { count_ = 0; }
  [[nodiscard]] bool empty() const { return count_ == 0; }
  /// Adds the limit zone of a block. To be called when the pass leaves the block, because the zone
  /// begins there.
  void add(const LimitZone& zone);
  /// Moves on by `length` mm: shortens all limit zones, and removes those that have ended. Where
  /// the plan is slow, a zone ends after the length of the time window even if the plan has not
  /// passed the zone's length.
  /// @param reach distance of half a window, in mm, at the greatest speed on these `length` mm
  void advance(float length, float reach);
  /// Returns the limit zones that restrict the next block, whose own limits are `own`.
  [[nodiscard]] BlockZones reaching(const LimitZone& own) const;

 private:
  static constexpr std::size_t kCapacity = 3;

  struct Reaching {
    LimitZone zone{};
    float whole = 0.0F;  ///< Initial length of the zone, mm.
  };

  void remove(std::size_t index);
  void merge_cheapest();

  std::array<Reaching, kCapacity + 1> zones_{};
  std::size_t count_ = 0;
};

}  // namespace cnc::motion
