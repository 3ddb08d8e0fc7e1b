#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <optional>
#include <vector>

#include "host-sim/surface/path/level_set.hpp"
#include "host-sim/surface/path/slice_curve.hpp"
#include "planner/contour/plane_curve.hpp"

namespace sim::surface {

/// A point of a level set, with the unit tangents before and after it. The tangents differ at a
/// corner.
struct LevelNode {
  Eigen::Vector2d place = Eigen::Vector2d::Zero();
  Eigen::Vector2d before = Eigen::Vector2d::UnitX();
  Eigen::Vector2d after = Eigen::Vector2d::UnitX();
};

/// A part of a level set as a smooth curve in plan. The curve consists of cubics whose ends have
/// the positions and tangents of the set.
class LevelCurve final : public cnc::contour::PlaneCurve {
 public:
  /// @param nodes nodes of the curve in order, at least two, all different
  /// @param min_mm length below which spans are straight
  LevelCurve(std::vector<LevelNode> nodes, double min_mm)
      : nodes_{std::move(nodes)}, min_mm_{min_mm} {}

  [[nodiscard]] std::size_t span_count() const override { return nodes_.size() - 1; }
  [[nodiscard]] SpanRange all() const { return {0, span_count()}; }
  [[nodiscard]] cnc::contour::CurveJet at(std::size_t span, double share) const override;

  [[nodiscard]] const std::vector<LevelNode>& nodes() const { return nodes_; }

 private:
  std::vector<LevelNode> nodes_;
  double min_mm_;
};

/// Returns the curves along successive points of a level set, in order. Each curve is checked at
/// points as close to each other as `density` requires. There, the set is within the error of the
/// curve, or the tip's height is within the error of the level. If there is no such curve between
/// two points, for example in a very narrow gap, one curve ends and the next curve begins.
/// @param places points of the set in order, at least two
/// @param is_low_left whether the low side is on the left of the points
[[nodiscard]] std::vector<LevelCurve> level_curves(const LevelSet& set,
                                                   const std::vector<Eigen::Vector2d>& places,
                                                   bool is_low_left,
                                                   const SliceDensity& density);

}  // namespace sim::surface
