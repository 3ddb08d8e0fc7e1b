#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <optional>

#include "host-sim/surface/drop_cutter.hpp"
#include "host-sim/surface/mesh.hpp"

namespace sim::surface {

/// Computes the heights of a tool's tip over a surface and a floor, and the rises of these heights.
class ToolHeights {
 public:
  /// @param floor_mm lowest height of the tip; also the tip's height where nothing is under the
  /// tool. Without a floor, the tip has no height at such points
  ToolHeights(const Mesh& mesh,
              const cnc::surface::Profile& profile,
              const std::optional<double>& floor_mm)
      : cutter_{mesh, profile}, floor_mm_{floor_mm.value_or(cnc::surface::kNoContact)} {}

  /// Returns the height of the tip at `place`, mm; cnc::surface::kNoContact if there is no height.
  [[nodiscard]] double operator()(const Eigen::Vector2d& place) const {
    return std::max(floor_mm_, cutter_.tip_height(place));
  }

  /// Returns the rise of the heights along X and along Y, mm per mm. It is a one-sided difference
  /// if one side has no height. Returns nothing if `place` has no height.
  [[nodiscard]] std::optional<Eigen::Vector2d> rise(const Eigen::Vector2d& place) const {
    const double height = (*this)(place);
    if (height == cnc::surface::kNoContact) return {};
    return Eigen::Vector2d{rise(place, height, Eigen::Vector2d::UnitX()),
                           rise(place, height, Eigen::Vector2d::UnitY())};
  }

 private:
  [[nodiscard]] double rise(const Eigen::Vector2d& place,
                            double height,
                            const Eigen::Vector2d& direction) const {
    constexpr double kBeside = 1.0e-5;
    double after = (*this)(place + kBeside * direction);
    double before = (*this)(place - kBeside * direction);
    double width = 2.0 * kBeside;
    if (after == cnc::surface::kNoContact) {
      after = height;
      width -= kBeside;
    }
    if (before == cnc::surface::kNoContact) {
      before = height;
      width -= kBeside;
    }
    return width > 0.5 * kBeside ? (after - before) / width : 0.0;
  }

  DropCutter cutter_;
  double floor_mm_;
};

}  // namespace sim::surface
