#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <optional>

#include "host-sim/surface/drop_cutter.hpp"
#include "host-sim/surface/path/level_border.hpp"
#include "host-sim/surface/path/surface_tracer.hpp"

namespace sim::surface {

/// The line in plan along which the grown tool's tip has one height. On one side the tip is higher,
/// and at this level the tool would cut into the surface there. A border counts as a surface that
/// rises by 1 mm per mm beyond it. Lengths are mm.
class LevelSet {
 public:
  /// @param border limits of the tip in plan; null for no limits
  /// @pre tracer and border outlive this object
  LevelSet(const SurfaceTracer& tracer, double level_mm, const LevelBorder* border = nullptr)
      : tracer_{&tracer}, level_mm_{level_mm}, border_{border} {}

  [[nodiscard]] double level_mm() const { return level_mm_; }

  /// Returns the height of the tip above the level at a place; -infinity if nothing is under the
  /// tip and there is no border.
  [[nodiscard]] double above(const Eigen::Vector2d& place) const {
    const double above = tracer_->touched(place, hint_) - level_mm_;
    return border_ == nullptr ? above : std::max(above, border_->beyond(place));
  }

  /// Returns where the line crosses the straight path between two places, on the low side of the
  /// line and within kExact of it. Where heights jump, the result is on the low side of the jump.
  /// @pre the tip is above the level at `high`, and not above it at `low`
  [[nodiscard]] Eigen::Vector2d crossing(Eigen::Vector2d low, Eigen::Vector2d high) const;

  /// Returns the crossing of the line with a straight path through a place, near that place;
  /// nothing if they do not cross.
  /// @param to_low direction in which the tip gets lower, a unit vector
  /// @param reach_mm greatest distance of the crossing from the place
  [[nodiscard]] std::optional<Eigen::Vector2d> near(const Eigen::Vector2d& place,
                                                    const Eigen::Vector2d& to_low,
                                                    double reach_mm) const;

  static constexpr double kExact = 1.0e-9;

 private:
  const SurfaceTracer* tracer_;
  double level_mm_;
  const LevelBorder* border_;
  mutable PathHeights::Hint hint_{};  ///< Changes the speed of a search, but no result.
};

}  // namespace sim::surface
