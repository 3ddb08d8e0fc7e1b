#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <optional>
#include <vector>

#include "host-sim/surface/path/level_loops.hpp"

namespace sim::surface {

/// The order in which the loops of levels are milled: down along one wall, then along the next. A
/// loop comes after all near loops of the level above. A loop without near loops there comes after
/// all higher levels.
class LoopOrder {
 public:
  /// @param loops loops by level, from the top; they outlive this object
  /// @param near_mm distance in plan up to which two loops count as near, above 0
  LoopOrder(const std::vector<LevelLoop>& loops, double near_mm);
  /// Uses a known order instead of deriving one from near loops.
  /// @param lower for each loop the loops that come after it
  LoopOrder(const std::vector<LevelLoop>& loops, std::vector<std::vector<std::size_t>> lower);

  /// Returns the number of the next loop and marks it as taken; nothing if all are taken. Of
  /// several possible loops it takes the one nearest to a place.
  [[nodiscard]] std::optional<std::size_t> take_next(const Eigen::Vector2d& here);

 private:
  std::size_t take(std::size_t loop);
  [[nodiscard]] std::optional<std::size_t> nearest_of(const std::vector<std::size_t>& loops,
                                                      const Eigen::Vector2d& here) const;
  [[nodiscard]] std::vector<std::size_t> highest_left();

  const std::vector<LevelLoop>* loops_;
  std::vector<std::vector<std::size_t>> lower_;  ///< For each loop the loops that wait for it.
  /// For each loop the number of loops to be milled before it.
  std::vector<std::size_t> waits_for_;
  std::vector<bool> is_taken_;
  std::vector<std::vector<std::size_t>> ready_;  ///< Groups of loops that waited for one loop.
  std::size_t first_left_ = 0;
};

}  // namespace sim::surface
