#pragma once

#include <Eigen/Core>
#include <functional>
#include <optional>

#include "host-sim/surface/path/plan_grid.hpp"
#include "host-sim/surface/path/row_path.hpp"
#include "host-sim/surface/path/surface_path.hpp"
#include "host-sim/surface/path/surface_tracer.hpp"

namespace sim::surface {

/// An end of a line at a level, and the direction of the line there.
struct LoopEnd {
  Eigen::Vector2d place = Eigen::Vector2d::Zero();
  Eigen::Vector2d tangent = Eigen::Vector2d::UnitX();  ///< Unit tangent in the direction of motion.
  double level_mm = 0.0;  ///< Height of the grown tool's tip at the level, mm.
};

/// Makes leads on the free side of a wall, as quarter turns or straight lines, and the paths
/// between leads. Leads and paths are checked with the exact heights of the grown tool's tip, so
/// that they never cut into the surface.
class LoopLeads {
 public:
  /// @param options milling direction, regions that bar links, and whether to use lines only
  /// @param lift_mm height of a tip above the level to which it belongs
  /// @pre tracer, grid and options outlive this object
  LoopLeads(const SurfaceTracer& tracer,
            const PlanGrid& grid,
            const RowOptions& options,
            double lift_mm);

  /// lead_in() returns the lead to the start of a line; lead_out() returns the lead from the end of
  /// a line. Both return nothing if there is no free space for a lead.
  [[nodiscard]] std::optional<SurfaceStretch> lead_in(const LoopEnd& start) const;
  [[nodiscard]] std::optional<SurfaceStretch> lead_out(const LoopEnd& end) const;

  /// Returns the straight path between two positions of the tip in space. Returns nothing if the
  /// path is longer in plan than 1.5 times the tool's radius: it may lead over stock that is left
  /// between lines. Also returns nothing if the path rises, would cut into the surface or would
  /// leave a region that bars links.
  [[nodiscard]] std::optional<SurfaceStretch> way_between(const Eigen::Vector3d& from,
                                                          const Eigen::Vector3d& to) const;

 private:
  /// Returns the lead between the end of a line and a point next to the line.
  /// @param sense 1 for a lead out, -1 for a lead in
  [[nodiscard]] std::optional<SurfaceStretch> lead(const LoopEnd& end, double sense) const;
  [[nodiscard]] bool is_in_regions(const Eigen::Vector2d& from, const Eigen::Vector2d& to) const;
  [[nodiscard]] bool is_free(const Eigen::Vector2d& place, double level_mm) const;

  const SurfaceTracer* tracer_;
  const PlanGrid* grid_;
  /// 1 if the free side is on the left in the direction of motion, -1 if it is on the right.
  double left_;
  bool lines_only_;
  double lift_mm_;
  const MilledRegions* regions_;
  /// Start of the next search. It affects only the search's speed, not its result.
  mutable PathHeights::Hint hint_{};
};

}  // namespace sim::surface
