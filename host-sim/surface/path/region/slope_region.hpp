#pragma once

#include <optional>

#include "host-sim/surface/path/region/sampled_region.hpp"
#include "host-sim/surface/path/region/tool_heights.hpp"

namespace sim::surface {

/// Slopes of a surface from the horizontal, radians.
struct SlopeRange {
  double least = 0.0;
  double most = 1.5707963267948966;
};

/// The places of a tool at which the surface that it touches has a slope in a range. The slope is
/// that of the tip's exact heights. The region extends by an eighth of the tool's radius, so that
/// two regions with a common limit overlap by a quarter of the radius.
class SlopeRegion final : public SampledRegion {
 public:
  /// @param floor_mm level where the tool does not touch the surface above it; without a floor such
  /// places are in no region
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
