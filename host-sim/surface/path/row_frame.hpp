#pragma once

#include <Eigen/Core>
#include <cmath>
#include <limits>

#include "host-sim/surface/mesh.hpp"
#include "host-sim/surface/path/slice.hpp"

namespace sim::surface {

/// A part of a row, mm. `row` is the row's coordinate across the rows; `begin` and `end` are
/// coordinates along the row.
struct RowPart {
  double row = 0.0;
  double begin = 0.0;
  double end = 0.0;
};

/// The bounding box of a surface in plan, in coordinates along and across rows.
class RowFrame {
 public:
  /// @param margin_mm distance by which the box is larger than the surface on all sides
  RowFrame(const Mesh& mesh, double angle_rad, double margin_mm)
      : along_{direction_of(angle_rad)},
        across_{-along_.y(), along_.x()},
        min_{Eigen::Vector2d::Constant(std::numeric_limits<double>::infinity())},
        max_{-min_} {
    for (const Eigen::Vector3d& point : mesh.points) {
      const Eigen::Vector2d seen{along_.dot(point.head<2>()), across_.dot(point.head<2>())};
      min_ = min_.cwiseMin(seen);
      max_ = max_.cwiseMax(seen);
    }
    min_.array() -= margin_mm;
    max_.array() += margin_mm;
  }

  [[nodiscard]] double first_row() const { return min_.y(); }
  [[nodiscard]] double last_row() const { return max_.y(); }
  [[nodiscard]] RowPart whole(double row) const { return {row, min_.x(), max_.x()}; }

  [[nodiscard]] Eigen::Vector2d at(double way, double row) const {
    return way * along_ + row * across_;
  }

  /// Returns the coordinates of `place` along and across the rows.
  [[nodiscard]] Eigen::Vector2d seen(const Eigen::Vector2d& place) const {
    return {along_.dot(place), across_.dot(place)};
  }

  /// Returns the slice over a part of a row. The slice goes from the part's begin to its end or, if
  /// `goes_back`, from its end to its begin.
  [[nodiscard]] Slice slice(const RowPart& part, bool goes_back) const {
    const double length = part.end - part.begin;
    return goes_back ? Slice{at(part.end, part.row), -along_, length}
                     : Slice{at(part.begin, part.row), along_, length};
  }

 private:
  /// Returns the unit vector of an angle. The vector is exact for directions along the axes, so
  /// that rows along the axes are exact.
  static Eigen::Vector2d direction_of(double angle_rad) {
    Eigen::Vector2d direction{std::cos(angle_rad), std::sin(angle_rad)};
    constexpr double kAlongAxis = 1.0e-12;
    for (double& part : direction) {
      if (std::abs(part) < kAlongAxis) part = 0.0;
      if (std::abs(part) > 1.0 - kAlongAxis) part = std::copysign(1.0, part);
    }
    return direction;
  }

  Eigen::Vector2d along_;
  Eigen::Vector2d across_;
  Eigen::Vector2d min_;  ///< Lowest coordinates of the box along and across the rows.
  Eigen::Vector2d max_;
};

}  // namespace sim::surface
