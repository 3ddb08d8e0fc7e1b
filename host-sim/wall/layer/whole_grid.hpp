#pragma once

#include <Eigen/Geometry>
#include <boost/polygon/polygon.hpp>
#include <cmath>

namespace sim::wall {

using WholePoint = boost::polygon::point_data<int>;

/// Converts points around a stock to whole numbers. The stock takes half of the range of a 32-bit
/// number, so that parts may extend beyond the stock.
class WholeGrid {
 public:
  explicit WholeGrid(const Eigen::AlignedBox2d& stock) : middle_{stock.center()} {
    constexpr double kNanometre = 1.0e-6;
    constexpr double kMax = 0x1.0p+30;
    const double reach = 0.5 * stock.sizes().maxCoeff() + 1.0;
    while (reach > kMax * step_ * kNanometre) step_ *= 2.0;
    step_ *= kNanometre;
  }

  [[nodiscard]] WholePoint whole(const Eigen::Vector2d& place) const {
    const Eigen::Vector2d steps = (place - middle_) / step_;
    return {static_cast<int>(std::lround(steps.x())), static_cast<int>(std::lround(steps.y()))};
  }
  [[nodiscard]] Eigen::Vector2d place(const WholePoint& whole) const {
    return middle_ + step_ * Eigen::Vector2d{whole.x(), whole.y()};
  }
  [[nodiscard]] double square_mm2() const { return step_ * step_; }

 private:
  Eigen::Vector2d middle_;
  double step_ = 1.0;
};

}  // namespace sim::wall
