#pragma once

#include <array>
#include <cstddef>

#include "planner/motion/block/block.hpp"

namespace cnc::motion {

/// Collects, along the path, what blocks that are left behind still ask for.
class ZoneTrail {
 public:
  void clear() { count_ = 0; }
  [[nodiscard]] bool empty() const { return count_ == 0; }
  /// A block of the path begins to be left: its limits reach so far.
  void add(const LimitZone& zone);
  /// So many mm further, which the plan drives at most so fast that half a window is
  /// `reach` mm: where it is slow, limits end for the time that it takes.
  void advance(float length, float reach);
  /// What reaches into a block whose own limits are these.
  [[nodiscard]] BlockZones reaching(const LimitZone& own) const;

 private:
  static constexpr std::size_t kCapacity = 3;

  struct Reaching {
    LimitZone zone{};
    float whole = 0.0F;  ///< mm, how far it reached at first.
  };

  void remove(std::size_t index);
  void merge_cheapest();

  std::array<Reaching, kCapacity + 1> zones_{};
  std::size_t count_ = 0;
};

}  // namespace cnc::motion
