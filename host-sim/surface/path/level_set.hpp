#pragma once

#include <Eigen/Core>
#include <optional>

#include "host-sim/surface/drop_cutter.hpp"
#include "host-sim/surface/path/surface_tracer.hpp"

namespace sim::surface {

/// The line in the plan along which the grown tool's tip has one height: on one side it is higher,
/// and there the tool would cut in at this level. Lengths are mm.
class LevelSet {
 public:
  /// @pre the tracer outlives this
  LevelSet(const SurfaceTracer& tracer, double level_mm) : tracer_{&tracer}, level_mm_{level_mm} {}

  [[nodiscard]] double level_mm() const { return level_mm_; }

  /// Returns how far the tip is above the level at a place; -infinity where nothing is under it.
  [[nodiscard]] double above(const Eigen::Vector2d& place) const {
    return tracer_->touched(place, hint_) - level_mm_;
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
  mutable PathHeights::Hint hint_{};  ///< Changes how soon an answer comes, but no answer.
};

}  // namespace sim::surface
