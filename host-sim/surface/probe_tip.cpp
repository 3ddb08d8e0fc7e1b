#include "host-sim/surface/probe_tip.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace sim::surface {
namespace {

/// Minimum area of a triangle with shifted corners, relative to the area of a triangle of the
/// regular grid.
constexpr double kMinShare = 0.1;
/// Number of halvings of a shift after which the shift is set to 0.
constexpr int kMaxStepHalvings = 20;

/// Access to the heights around one point, along its row or its column.
struct TipNeighbours {
  const std::vector<Eigen::Vector3d>& tips;
  std::size_t index;   ///< Index of the point.
  std::size_t stride;  ///< Difference between the indices of neighbours.
  std::size_t before;  ///< Number of points before the point in its row or column.
  std::size_t behind;
  Eigen::Index axis;

  [[nodiscard]] bool has(std::ptrdiff_t step) const {
    const auto free = static_cast<std::ptrdiff_t>(step < 0 ? before : behind);
    return std::abs(step) <= free && !std::isnan(point(step).z());
  }
  [[nodiscard]] const Eigen::Vector3d& point(std::ptrdiff_t step) const {
    return tips[static_cast<std::size_t>(static_cast<std::ptrdiff_t>(index) +
                                         step * static_cast<std::ptrdiff_t>(stride))];
  }
  /// Returns the slope between two neighbours. `from` and `to` are the numbers of steps from the
  /// point to the neighbours.
  /// @pre both neighbours have a height
  [[nodiscard]] double chord(std::ptrdiff_t from, std::ptrdiff_t to) const {
    return (point(to).z() - point(from).z()) / (point(to)[axis] - point(from)[axis]);
  }
  /// Returns the slope at the point. The slope has second-order accuracy if three points are known.
  [[nodiscard]] double slope() const {
    if (has(-1) && has(1)) return chord(-1, 1);
    for (const std::ptrdiff_t side : {1, -1}) {
      if (!has(side)) continue;
      return has(2 * side) ? 2.0 * chord(0, side) - chord(0, 2 * side) : chord(0, side);
    }
    return 0.0;
  }
};

Eigen::Vector2d gradient_at(const ProbeGrid& grid,
                            const std::vector<Eigen::Vector3d>& tips,
                            std::size_t index) {
  const std::size_t column = index % grid.x.count;
  const std::size_t row = index / grid.x.count;
  const TipNeighbours along_x{tips, index, 1, column, grid.x.count - 1 - column, 0};
  const TipNeighbours along_y{tips, index, grid.x.count, row, grid.y.count - 1 - row, 1};
  return {along_x.slope(), along_y.slope()};
}

/// Shifts each point from the ball's lowest point to the point of contact. Shortens shifts where
/// the grid would fold.
class TipShifter {
 public:
  TipShifter(const ProbeGrid& grid, const std::vector<Eigen::Vector3d>& tips, double radius_mm)
      : grid_{grid},
        tips_{tips},
        radius_mm_{radius_mm},
        min_{kMinShare * grid.x.pitch_mm() * grid.y.pitch_mm()} {
    for (std::size_t i = 0; i < tips.size(); ++i) {
      Eigen::Vector2d shift = Eigen::Vector2d::Zero();
      if (!std::isnan(tips[i].z())) {
        const Eigen::Vector2d gradient = gradient_at(grid, tips, i);
        shift = gradient * (radius_mm / std::sqrt(1.0 + gradient.squaredNorm()));
      }
      shifts_.push_back(shift);
    }
  }

  void unfold() {
    for (int i = 0; i <= kMaxStepHalvings; ++i) {
      std::vector<bool> folded(tips_.size(), false);
      if (!mark_folded(folded)) return;
      const double share = i < kMaxStepHalvings ? 0.5 : 0.0;
      for (std::size_t k = 0; k < shifts_.size(); ++k) {
        if (folded[k]) shifts_[k] *= share;
      }
    }
  }

  [[nodiscard]] std::vector<Eigen::Vector3d> points() const {
    std::vector<Eigen::Vector3d> points;
    for (std::size_t i = 0; i < tips_.size(); ++i) {
      const double out_square = std::min(shifts_[i].squaredNorm(), radius_mm_ * radius_mm_);
      const double across = std::sqrt(radius_mm_ * radius_mm_ - out_square);
      points.emplace_back(tips_[i].x() + shifts_[i].x(),
                          tips_[i].y() + shifts_[i].y(),
                          tips_[i].z() + out_square / (radius_mm_ + across));
    }
    return points;
  }

 private:
  [[nodiscard]] Eigen::Vector2d place(std::size_t index) const {
    return tips_[index].head<2>() + shifts_[index];
  }

  /// Marks the corners of each folded quadrilateral. A quadrilateral is folded if three of its
  /// corners form a triangle that is flipped or too small. Returns whether any is folded.
  bool mark_folded(std::vector<bool>& folded) const {
    bool any = false;
    for (std::size_t row = 0; row + 1 < grid_.y.count; ++row) {
      for (std::size_t column = 0; column + 1 < grid_.x.count; ++column) {
        const std::size_t at = row * grid_.x.count + column;
        const std::array corners{at, at + 1, at + grid_.x.count + 1, at + grid_.x.count};
        if (!is_folded(corners)) continue;
        any = true;
        for (const std::size_t corner : corners) folded[corner] = true;
      }
    }
    return any;
  }

  [[nodiscard]] bool is_folded(const std::array<std::size_t, 4>& corners) const {
    for (std::size_t i = 0; i < corners.size(); ++i) {
      const Eigen::Vector2d from = place(corners[i]);
      const Eigen::Vector2d u = place(corners[(i + 1) % 4]) - from;
      const Eigen::Vector2d v = place(corners[(i + 3) % 4]) - from;
      if (u.x() * v.y() - u.y() * v.x() < min_) return true;
    }
    return false;
  }

  const ProbeGrid& grid_;
  const std::vector<Eigen::Vector3d>& tips_;
  double radius_mm_;
  double min_;  ///< Lower limit of twice the area of a triangle, mm².
  std::vector<Eigen::Vector2d> shifts_;
};

}  // namespace

std::vector<Eigen::Vector3d> touched_points(const ProbeGrid& grid,
                                            const std::vector<Eigen::Vector3d>& tips,
                                            double tip_mm) {
  if (tip_mm <= 0.0) return tips;
  TipShifter shifter{grid, tips, 0.5 * tip_mm};
  shifter.unfold();
  return shifter.points();
}

}  // namespace sim::surface
