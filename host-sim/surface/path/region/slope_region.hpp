#pragma once

#include <optional>

#include "host-sim/surface/path/region/sampled_region.hpp"
#include "host-sim/surface/path/region/tool_heights.hpp"

namespace sim::surface {

/// A range of slopes of a surface, measured from the horizontal, radians.
struct SlopeRange {
  double least = 0.0;
  double most = 1.5707963267948966;
};

/// The region in which the surface at the tool's contact has a slope in a range. The slope is
/// computed from the exact heights of the tip. The region is extended by an eighth of the tool's
/// radius, so that two regions with a common limit overlap by a quarter of the radius.
class SlopeRegion final : public SampledRegion {
 public:
  /// @param floor_mm level that counts as surface where the tool touches no surface above this
  /// level. Without a floor, such points are in no region
  SlopeRegion(const Mesh& mesh,
              const cnc::surface::Profile& tool,
              const std::optional<double>& floor_mm,
              const SlopeRange& range);

 private:
  [[nodiscard]] bool holds(const Eigen::Vector2d& place, std::size_t& memory) const override;

  ToolHeights heights_;
  SlopeRange range_;
};

}  // namespace sim::surface
