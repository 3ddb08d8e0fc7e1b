#include "host-sim/surface/path/region/slope_region.hpp"

#include <cmath>

namespace sim::surface {
SlopeRegion::SlopeRegion(const Mesh& mesh,
                         const cnc::surface::Profile& tool,
                         const std::optional<double>& floor_mm,
                         const SlopeRange& range)
    : SampledRegion{tool.radius_mm}, heights_{mesh, tool, floor_mm}, range_{range} {}

bool SlopeRegion::holds(const Eigen::Vector2d& place, std::size_t& /*memory*/) const {
  const std::optional<Eigen::Vector2d> rise = heights_.rise(place);
  if (!rise) return false;
  const double slope = std::atan(rise->norm());
  return slope >= range_.least && slope <= range_.most;
}

}  // namespace sim::surface
