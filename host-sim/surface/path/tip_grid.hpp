#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <functional>
#include <vector>

#include "host-sim/surface/path/plan_grid.hpp"
#include "host-sim/surface/path/surface_tracer.hpp"

namespace sim::surface {

/// The exact heights of the grown tool's tip over the nodes of a grid, mm.
class TipGrid {
 public:
  /// @param progress called with the finished share of the nodes, 0 to 1; may be empty
  TipGrid(const SurfaceTracer& tracer,
          const PlanGrid& grid,
          const std::function<void(double)>& progress);

  [[nodiscard]] const PlanGrid& grid() const { return grid_; }
  /// Returns the height over a node; cnc::surface::kNoContact if nothing is under the tool and
  /// there is no floor.
  [[nodiscard]] double height(std::size_t node) const { return heights_[node]; }
  [[nodiscard]] bool has_contact(std::size_t node) const {
    return heights_[node] != cnc::surface::kNoContact;
  }
  /// Returns the position of the tip over a node.
  /// @pre has_contact()
  [[nodiscard]] Eigen::Vector3d tip(std::size_t node) const {
    const Eigen::Vector2d seen = grid_.at(node);
    return {seen.x(), seen.y(), heights_[node]};
  }

  /// Returns whether any node has a height.
  [[nodiscard]] bool has_any() const { return highest_mm_ >= lowest_mm_; }
  /// lowest_mm() returns the lowest height of all nodes, highest_mm() the highest.
  /// @pre has_any()
  [[nodiscard]] double lowest_mm() const { return lowest_mm_; }
  [[nodiscard]] double highest_mm() const { return highest_mm_; }

 private:
  PlanGrid grid_;
  std::vector<double> heights_;
  double lowest_mm_;
  double highest_mm_;
};

}  // namespace sim::surface
