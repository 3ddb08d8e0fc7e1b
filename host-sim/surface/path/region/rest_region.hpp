#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "host-sim/surface/path/region/sampled_region.hpp"
#include "host-sim/surface/path/region/tip_raster.hpp"
#include "host-sim/surface/path/region/tool_heights.hpp"

namespace sim::surface {

/// Data of the earlier, larger tool, and limits for the stock that requires another pass.
struct RestOptions {
  /// Profile of the larger tool. Its radius exceeds the radius of the tool.
  cnc::surface::Profile larger;
  double larger_allowance_mm = 0.0;
  /// Thickness, perpendicular to the tool, above which stock is rest stock.
  double depth_mm = 0.03;
  double allowance_mm = 0.0;         ///< Allowance that the tool leaves.
  std::optional<double> floor_mm{};  ///< Lowest height of the tip for both tools.
};

/// The region of rest stock. It consists of the positions of a tool at which a larger tool leaves
/// stock thicker than `depth_mm`, wherever the larger tool moves. The reduced tool is smaller than
/// the tool by this depth on all sides. In the region, it reaches stock that the larger tool cannot
/// remove.
///
/// If one position of the larger tool removes everything that the reduced tool removes, there is no
/// rest stock. Otherwise 37 points of the reduced tool are checked. For each point, a position of
/// the larger tool is searched that removes the stock there. If a search misses such a position,
/// the region becomes larger, never smaller.
class RestRegion final : public SampledRegion {
 public:
  RestRegion(const Mesh& mesh, const cnc::surface::Profile& tool, const RestOptions& options);

 private:
  /// A point of the reduced tool, relative to the tool's tip.
  struct ToolPoint {
    Eigen::Vector2d out;
    double height;
  };

  [[nodiscard]] bool holds(const Eigen::Vector2d& place, std::size_t& memory) const override;
  [[nodiscard]] bool is_taken_at_once(const Eigen::Vector3d& tip,
                                      const Eigen::Vector2d& rise) const;
  [[nodiscard]] bool is_all_taken(const Eigen::Vector3d& tip, const Eigen::Vector2d& place) const;
  [[nodiscard]] double clearance(double distance_mm) const;
  [[nodiscard]] bool is_taken(const Eigen::Vector3d& point,
                              const Eigen::Vector2d& out,
                              const Eigen::Vector2d& rise) const;
  [[nodiscard]] double excess(const Eigen::Vector3d& point, const Eigen::Vector2d& place) const;
  [[nodiscard]] bool is_taken_by_search(const Eigen::Vector3d& point) const;

  ToolHeights heights_;  ///< Heights of the tool that is grown by its allowance, without the lift.
  /// Heights of the larger tool that is grown by its allowance, without the lift.
  ToolHeights larger_heights_;
  cnc::surface::Profile tool_;
  cnc::surface::Profile larger_;
  double lift_mm_;
  double larger_lift_mm_;
  TipRaster raster_;
  std::vector<ToolPoint> points_;
  /// Clearances: least heights of the tool's tip above the larger tool's tip at which the larger
  /// tool removes everything that the reduced tool removes. The entries are for distances between
  /// the tools' axes from 0 to reach_mm_, in decreasing steps.
  std::vector<double> clearances_;
  double reach_mm_;
};

}  // namespace sim::surface
