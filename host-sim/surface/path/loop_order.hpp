#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <optional>
#include <vector>

#include "host-sim/surface/path/level_loops.hpp"

namespace sim::surface {

/// The order in which the loops of levels are milled: down along one wall, then along the next. A
/// loop comes after all those of the level above that are near it; one that has none near comes
/// after all higher levels.
class LoopOrder {
 public:
  /// @param loops by level, from the top; must outlive this
  /// @param near_mm distance in plan up to which one loop is near another, above 0
  LoopOrder(const std::vector<LevelLoop>& loops, double near_mm);
  /// Takes an order that is known, in place of that of near loops.
  /// @param lower for each loop those that come after it
  LoopOrder(const std::vector<LevelLoop>& loops, std::vector<std::vector<std::size_t>> lower);

  /// Returns the number of the next loop, and takes it; nothing if all are taken. Of several the
  /// nearest to a place is taken.
  [[nodiscard]] std::optional<std::size_t> take_next(const Eigen::Vector2d& here);

 private:
  std::size_t take(std::size_t loop);
  [[nodiscard]] std::optional<std::size_t> nearest_of(const std::vector<std::size_t>& loops,
                                                      const Eigen::Vector2d& here) const;
  [[nodiscard]] std::vector<std::size_t> highest_left();

  const std::vector<LevelLoop>* loops_;
  std::vector<std::vector<std::size_t>> lower_;  ///< For each loop, those that wait for it.
  std::vector<std::size_t> waits_for_;           ///< How many are to be milled before.
  std::vector<bool> is_taken_;
  std::vector<std::vector<std::size_t>> ready_;  ///< Groups that waited for one loop.
  std::size_t first_left_ = 0;
};

}  // namespace sim::surface
