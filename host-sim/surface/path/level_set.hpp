#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <optional>

#include "host-sim/surface/drop_cutter.hpp"
#include "host-sim/surface/path/level_border.hpp"
#include "host-sim/surface/path/surface_tracer.hpp"

namespace sim::surface {

/// The line in plan along which the grown tool's tip in contact has the height of a level. On one
/// side of the line, the tip in contact is higher; a tool at the level would cut into the surface
/// there. A border acts as a surface that begins at the level and rises by 1 mm for each mm beyond
/// the border. Lengths are mm.
class LevelSet {
 public:
  /// @param border limits of the tip in plan; null if there are no limits
  /// @pre tracer and border outlive this object
  LevelSet(const SurfaceTracer& tracer, double level_mm, const LevelBorder* border = nullptr)
      : tracer_{&tracer}, level_mm_{level_mm}, border_{border} {}

  [[nodiscard]] double level_mm() const { return level_mm_; }

  /// Returns the height of the tip in contact above the level, at `place`; -infinity if nothing is
  /// under the tip and there is no border.
  [[nodiscard]] double above(const Eigen::Vector2d& place) const {
    const double above = tracer_->touched(place, hint_) - level_mm_;
    return border_ == nullptr ? above : std::max(above, border_->beyond(place));
  }

  /// Returns the crossing of the line with the straight path from `low` to `high`. The result is on
  /// the low side of the line or of a jump, within kExact.
  /// @pre the tip is above the level at `high`, and not above it at `low`
  [[nodiscard]] Eigen::Vector2d crossing(Eigen::Vector2d low, Eigen::Vector2d high) const;

  /// Returns the crossing of the line with a straight path that begins at `place`; nothing if there
  /// is no crossing within `reach_mm`.
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
  /// Start of the next search. It affects only the search's speed, not its result.
  mutable PathHeights::Hint hint_{};
};

}  // namespace sim::surface
