#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

#include "host-sim/surface/mesh.hpp"
#include "host-sim/surface/path/region/tool_heights.hpp"

namespace sim::surface {

/// Heights of a tool's tip on a square grid over a surface, as starting points for searches.
class TipRaster {
 public:
  /// @param margin_mm distance by which the grid extends beyond the surface's box
  /// @param pitch_mm distance between points of the grid. It is increased if there would be more
  /// than four million points
  TipRaster(const ToolHeights& heights, const Mesh& mesh, double margin_mm, double pitch_mm) {
    Eigen::Vector2d least = mesh.points.front().head<2>();
    Eigen::Vector2d most = least;
    for (const Eigen::Vector3d& point : mesh.points) {
      least = least.cwiseMin(point.head<2>());
      most = most.cwiseMax(point.head<2>());
    }
    min_ = least.array() - margin_mm;
    const Eigen::Vector2d size = most.array() + margin_mm - min_.array();
    constexpr double kMaxTips = 4.0e6;
    pitch_mm_ = std::max(pitch_mm, std::sqrt(size.x() * size.y() / kMaxTips));
    columns_ = 1 + static_cast<int>(std::ceil(size.x() / pitch_mm_));
    rows_ = 1 + static_cast<int>(std::ceil(size.y() / pitch_mm_));
    heights_.reserve(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_));
    for (int row = 0; row < rows_; ++row) {
      for (int column = 0; column < columns_; ++column) {
        heights_.push_back(heights(place_of(column, row)));
      }
    }
  }

  [[nodiscard]] double pitch_mm() const { return pitch_mm_; }

  /// Returns the grid point with the least `cost(distance, height)` among all grid points within
  /// `radius_mm` of `place`. Returns `place` if nothing is under the tool at any of these points.
  template <typename Cost>
  [[nodiscard]] Eigen::Vector2d best(const Eigen::Vector2d& place,
                                     double radius_mm,
                                     const Cost& cost) const {
    const Eigen::Vector2d first = (place - min_).array() - radius_mm;
    const Eigen::Vector2d last = (place - min_).array() + radius_mm;
    Eigen::Vector2d found = place;
    double lowest = std::numeric_limits<double>::infinity();
    for (int row = index_from(first.y(), rows_); row < index_from(last.y(), rows_); ++row) {
      for (int column = index_from(first.x(), columns_); column < index_from(last.x(), columns_);
           ++column) {
        const Eigen::Vector2d at = place_of(column, row);
        const double square = (at - place).squaredNorm();
        const double height =
            heights_[static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) +
                     static_cast<std::size_t>(column)];
        if (square > radius_mm * radius_mm || height == cnc::surface::kNoContact) continue;
        const double value = cost(std::sqrt(square), height);
        if (value >= lowest) continue;
        lowest = value;
        found = at;
      }
    }
    return found;
  }

 private:
  [[nodiscard]] Eigen::Vector2d place_of(int column, int row) const {
    return min_ + pitch_mm_ * Eigen::Vector2d{column, row};
  }
  /// Returns the index of the first grid point whose distance from the grid's start is at least
  /// `distance_mm`; at most `count`.
  [[nodiscard]] int index_from(double distance_mm, int count) const {
    return static_cast<int>(std::clamp(std::ceil(distance_mm / pitch_mm_), 0.0, 1.0 * count));
  }

  Eigen::Vector2d min_ = Eigen::Vector2d::Zero();
  double pitch_mm_ = 0.0;
  int columns_ = 0;
  int rows_ = 0;
  std::vector<double> heights_;  ///< Heights row by row.
};

}  // namespace sim::surface
