#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "host-sim/surface/path/region/sampled_region.hpp"
#include "host-sim/surface/path/region/tip_raster.hpp"
#include "host-sim/surface/path/region/tool_heights.hpp"

namespace sim::surface {

/// An earlier, larger tool, and the limits of the stock that is worth another pass.
struct RestOptions {
  /// Profile of the larger tool; its radius is above that of the tool.
  cnc::surface::Profile larger;
  double larger_allowance_mm = 0.0;
  /// Stock thicker than this, perpendicular to the tool, is rest stock.
  double depth_mm = 0.03;
  double allowance_mm = 0.0;         ///< Stock that the tool leaves.
  std::optional<double> floor_mm{};  ///< Lowest height of the tip, for both tools.
};

/// The places at which a tool touches the surface and a larger tool leaves stock thicker than a
/// depth, wherever the larger tool goes. At these places the tool, reduced by the depth on all
/// sides, reaches beyond everything that the larger tool can remove.
///
/// If one place of the larger tool removes everything that the reduced tool does, nothing is left.
/// Otherwise 37 points of the tool are checked, each by a search for a place of the larger tool
/// that removes the stock there. A search that misses such a place makes the region larger, never
/// smaller.
class RestRegion final : public SampledRegion {
 public:
  RestRegion(const Mesh& mesh, const cnc::surface::Profile& tool, const RestOptions& options);

 private:
  /// A point of the tool, relative to its tip.
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

  ToolHeights heights_;  ///< Heights of the tool with its allowance, without its lift.
  /// Heights of the larger tool with its allowance, without its lift.
  ToolHeights larger_heights_;
  cnc::surface::Profile tool_;
  cnc::surface::Profile larger_;
  double lift_mm_;
  double larger_lift_mm_;
  TipRaster raster_;
  std::vector<ToolPoint> points_;
  /// Heights of the larger tool's tip above the tool's tip at which the larger tool removes
  /// everything that the tool does, by the distance between their axes. The distances go from 0 to
  /// the difference of the radii in steps that become shorter.
  std::vector<double> clearances_;
  double reach_mm_;
};

}  // namespace sim::surface
