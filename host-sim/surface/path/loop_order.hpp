#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <optional>
#include <vector>

#include "host-sim/surface/path/level_loops.hpp"

namespace sim::surface {

/// Finds the order in which the loops of all levels are milled: down along one wall, then down
/// along the next wall. A loop comes after all near loops of the level above. A loop without near
/// loops on the level above comes after all higher levels.
class LoopOrder {
 public:
  /// @param loops loops sorted by level, the top level first; they outlive this object
  /// @param near_mm distance in plan up to which two loops count as near, above 0
  LoopOrder(const std::vector<LevelLoop>& loops, double near_mm);
  /// Uses a known order instead of deriving one from near loops.
  /// @param lower for each loop, the loops that must come after it
  LoopOrder(const std::vector<LevelLoop>& loops, std::vector<std::vector<std::size_t>> lower);

  /// Returns the number of the next loop and marks the loop as taken; nothing if all loops are
  /// taken. Of several possible loops, the loop nearest to `here` is taken.
  [[nodiscard]] std::optional<std::size_t> take_next(const Eigen::Vector2d& here);

 private:
  std::size_t take(std::size_t loop);
  [[nodiscard]] std::optional<std::size_t> nearest_of(const std::vector<std::size_t>& loops,
                                                      const Eigen::Vector2d& here) const;
  [[nodiscard]] std::vector<std::size_t> highest_left();

  const std::vector<LevelLoop>* loops_;
  /// For each loop, the loops that must be milled after it.
  std::vector<std::vector<std::size_t>> lower_;
  /// Number of loops that must be milled before a loop, for each loop.
  std::vector<std::size_t> waits_for_;
  std::vector<bool> is_taken_;
  /// Groups of loops that may be milled. All loops of a group waited for the same loop. The last
  /// group is milled first.
  std::vector<std::vector<std::size_t>> ready_;
  std::size_t first_left_ = 0;
};

}  // namespace sim::surface
