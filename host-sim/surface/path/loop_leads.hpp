#pragma once

#include <Eigen/Core>
#include <functional>
#include <optional>

#include "host-sim/surface/path/plan_grid.hpp"
#include "host-sim/surface/path/row_path.hpp"
#include "host-sim/surface/path/surface_path.hpp"
#include "host-sim/surface/path/surface_tracer.hpp"

namespace sim::surface {

/// The end of a line in a level, and how it goes there.
struct LoopEnd {
  Eigen::Vector2d place = Eigen::Vector2d::Zero();
  Eigen::Vector2d tangent = Eigen::Vector2d::UnitX();  ///< Unit vector, as it is driven.
  double level_mm = 0.0;                               ///< Height of the grown tool's tip.
};

/// Leads of quarter turns, or straight ones, on the free side of a wall, and the ways between them.
/// All are checked against the exact heights of the grown tool's tip, so that they never cut in.
class LoopLeads {
 public:
  /// @param options the side of the surface, regions that bar links, and whether leads are lines
  /// @param lift_mm height of a tip over the level that it belongs to
  /// @pre tracer, grid and options outlive this
  LoopLeads(const SurfaceTracer& tracer,
            const PlanGrid& grid,
            const RowOptions& options,
            double lift_mm);

  /// Returns the lead to the start of a line, and the one from its end;
  /// nothing where there is no space.
  [[nodiscard]] std::optional<SurfaceStretch> lead_in(const LoopEnd& start) const;
  [[nodiscard]] std::optional<SurfaceStretch> lead_out(const LoopEnd& end) const;

  /// Returns the straight way between two places of the tip in space, not above where it begins;
  /// nothing where it is longer in plan than 1.5 radii, as stock may stand beside lines, or where
  /// it rises, would cut in or leave a region that bars links.
  [[nodiscard]] std::optional<SurfaceStretch> way_between(const Eigen::Vector3d& from,
                                                          const Eigen::Vector3d& to) const;

 private:
  /// Returns the lead between a line and a place beside it. @param sense 1 if it leads out, -1 if
  /// in.
  [[nodiscard]] std::optional<SurfaceStretch> lead(const LoopEnd& end, double sense) const;
  [[nodiscard]] bool is_in_regions(const Eigen::Vector2d& from, const Eigen::Vector2d& to) const;
  [[nodiscard]] bool is_free(const Eigen::Vector2d& place, double level_mm) const;

  const SurfaceTracer* tracer_;
  const PlanGrid* grid_;
  double left_;  ///< 1 if the free side is on the left as lines are driven, -1 on the right.
  bool lines_only_;
  double lift_mm_;
  const MilledRegions* regions_;
  mutable PathHeights::Hint hint_{};  ///< Changes how soon an answer comes, but no answer.
};

}  // namespace sim::surface
