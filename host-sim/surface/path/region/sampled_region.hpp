#pragma once

#include "host-sim/surface/path/region/milled_region.hpp"

namespace sim::surface {

/// The places of which something holds, and all within a distance of them. Borders are found by
/// bisection to 1e-6 mm on five parallel slices within that distance.
class SampledRegion : public MilledRegion {
 public:
  /// Returns the parts; gaps up to twice the overlap are no gaps, so that none is shorter than
  /// that, but at the ends of the slice. What lies between two samples alone is not found.
  [[nodiscard]] SliceParts parts_of(const Slice& slice, double begin, double end) const final;

 protected:
  /// Samples lie an eighth of the tool's radius apart, and by as much the region goes on.
  explicit SampledRegion(double tool_radius_mm) : overlap_mm_{0.125 * tool_radius_mm} {}

  /// @param memory 0 at first, then what the last call on a place near by wrote
  [[nodiscard]] virtual bool holds(const Eigen::Vector2d& place, std::size_t& memory) const = 0;

 private:
  class Sampler;

  double overlap_mm_;  ///< Also the distance of samples.
};

}  // namespace sim::surface
