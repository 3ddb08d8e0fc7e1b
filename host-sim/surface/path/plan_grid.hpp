#pragma once

#include <Eigen/Core>
#include <cstddef>

#include "host-sim/surface/mesh.hpp"

namespace sim::surface {

/// A regular grid of nodes over a rectangle in plan, along X and Y. The outer nodes are on the
/// border of the rectangle. Lengths are mm.
class PlanGrid {
 public:
  /// Maximum number of nodes. The limit keeps the memory within the capacity of a common computer.
  static constexpr double kMaxNodes = 4.0e7;

  /// Lays the grid over the box of a surface in plan.
  /// @param margin_mm distance by which the grid is larger than the box on all sides
  /// @param max_pitch_mm greatest distance between two nodes along X and along Y, above 0
  /// Throws std::invalid_argument for more than kMaxNodes nodes.
  PlanGrid(const Mesh& mesh, double margin_mm, double max_pitch_mm);

  [[nodiscard]] std::size_t columns() const { return columns_; }
  [[nodiscard]] std::size_t rows() const { return rows_; }
  [[nodiscard]] std::size_t size() const { return columns_ * rows_; }
  [[nodiscard]] const Eigen::Vector2d& pitch() const { return pitch_; }
  /// Returns the length of a cell's diagonal.
  [[nodiscard]] double diagonal() const { return pitch_.norm(); }

  [[nodiscard]] std::size_t node(std::size_t column, std::size_t row) const {
    return row * columns_ + column;
  }
  [[nodiscard]] Eigen::Vector2d at(std::size_t node) const {
    return at(node % columns_, node / columns_);
  }
  [[nodiscard]] Eigen::Vector2d at(std::size_t column, std::size_t row) const {
    const Eigen::Vector2d cells{static_cast<double>(column), static_cast<double>(row)};
    return min_ + cells.cwiseProduct(pitch_);
  }
  /// Returns whether `place` is inside the rectangle or on its border.
  [[nodiscard]] bool holds(const Eigen::Vector2d& place) const {
    const Eigen::Array2d inside = place - min_;
    const Eigen::Array2d rest = at(columns_ - 1, rows_ - 1) - place;
    return inside.minCoeff() >= 0.0 && rest.minCoeff() >= 0.0;
  }
  /// Returns whether a node is on the border of the rectangle.
  [[nodiscard]] bool is_on_border(std::size_t node) const {
    const std::size_t column = node % columns_;
    const std::size_t row = node / columns_;
    return column == 0 || row == 0 || column + 1 == columns_ || row + 1 == rows_;
  }

 private:
  Eigen::Vector2d min_ = Eigen::Vector2d::Zero();
  Eigen::Vector2d pitch_ = Eigen::Vector2d::Zero();
  std::size_t columns_ = 0;
  std::size_t rows_ = 0;
};

}  // namespace sim::surface
