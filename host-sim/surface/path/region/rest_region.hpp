#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "host-sim/surface/path/region/sampled_region.hpp"
#include "host-sim/surface/path/region/tip_raster.hpp"
#include "host-sim/surface/path/region/tool_heights.hpp"

namespace sim::surface {

/// An earlier, larger tool, and the stock for which it is worth to go on.
struct RestOptions {
  cnc::surface::Profile larger;  ///< Its radius is above that of the tool.
  double larger_allowance_mm = 0.0;
  double depth_mm = 0.03;     ///< Thicker stock is a rest, measured at right angles to the tool.
  double allowance_mm = 0.0;  ///< Stock that the tool leaves.
  std::optional<double> floor_mm{};  ///< For both tools.
};

/// The places at which a tool touches the surface where a larger one, in whatever place, leaves
/// more than a depth: where that tool, smaller by the depth all round, reaches beyond all that the
/// larger one can take.
///
/// Where one place of the larger tool takes all of the smaller one, nothing is left. Elsewhere 37
/// points of the tool are checked, each by a search for a place of the larger tool that takes it. A
/// search that misses such a place makes the region larger, never smaller.
class RestRegion final : public SampledRegion {
 public:
  RestRegion(const Mesh& mesh, const cnc::surface::Profile& tool, const RestOptions& options);

 private:
  /// A point of the tool, seen from its tip.
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

  ToolHeights heights_;         ///< With the allowance, less its lift.
  ToolHeights larger_heights_;  ///< The same of the larger tool.
  cnc::surface::Profile tool_;
  cnc::surface::Profile larger_;
  double lift_mm_;
  double larger_lift_mm_;
  TipRaster raster_;
  std::vector<ToolPoint> points_;
  /// Heights of the larger tool's tip above the tool's by which it takes all of it, by the distance
  /// of their axes: 0 to the difference of the radii in steps that become shorter.
  std::vector<double> clearances_;
  double reach_mm_;
};

}  // namespace sim::surface
