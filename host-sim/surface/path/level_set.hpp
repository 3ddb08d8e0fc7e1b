#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <optional>

#include "host-sim/surface/drop_cutter.hpp"
#include "host-sim/surface/path/level_border.hpp"
#include "host-sim/surface/path/surface_tracer.hpp"

namespace sim::surface {

/// The line in the plan along which the grown tool's tip has one height: on one side it is higher,
/// and there the tool would cut in at this level. A border counts as a surface, too, that rises by
/// 1 mm per mm. Lengths are mm.
class LevelSet {
 public:
  /// @param border limits of the tip in the plan; null: there are none
  /// @pre tracer and border outlive this
  LevelSet(const SurfaceTracer& tracer, double level_mm, const LevelBorder* border = nullptr)
      : tracer_{&tracer}, level_mm_{level_mm}, border_{border} {}

  [[nodiscard]] double level_mm() const { return level_mm_; }

  /// Returns how far the tip is above the level at a place; -infinity where nothing is under it
  /// and there is no border.
  [[nodiscard]] double above(const Eigen::Vector2d& place) const {
    const double above = tracer_->touched(place, hint_) - level_mm_;
    return border_ == nullptr ? above : std::max(above, border_->beyond(place));
  }

  /// Returns where the line crosses the way between two places, on the low side of it and within
  /// kExact. Where heights jump this is beside the jump. @pre the tip is not above the level at
  /// `low`, and above it at `high`
  [[nodiscard]] Eigen::Vector2d crossing(Eigen::Vector2d low, Eigen::Vector2d high) const;

  /// Returns where the line crosses a straight way through a place, near it; nothing if it does
  /// not. @param to_low direction in which the tip gets lower, a unit vector
  /// @param reach_mm greatest distance from the place
  [[nodiscard]] std::optional<Eigen::Vector2d> near(const Eigen::Vector2d& place,
                                                    const Eigen::Vector2d& to_low,
                                                    double reach_mm) const;

  static constexpr double kExact = 1.0e-9;

 private:
  const SurfaceTracer* tracer_;
  double level_mm_;
  const LevelBorder* border_;
  mutable PathHeights::Hint hint_{};  ///< Changes how soon an answer comes, but no answer.
};

}  // namespace sim::surface
