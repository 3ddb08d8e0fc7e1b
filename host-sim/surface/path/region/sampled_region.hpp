#pragma once

#include "host-sim/surface/path/region/milled_region.hpp"

namespace sim::surface {

/// The places at which a condition holds, and all places within a distance of them. Borders are
/// found by bisection to 1e-6 mm on five parallel slices within that distance.
class SampledRegion : public MilledRegion {
 public:
  /// Returns the parts of the slice. Gaps up to twice the overlap are closed, so that no part is
  /// shorter than that, except at the ends of the slice. A feature that lies between two samples is
  /// not found.
  [[nodiscard]] SliceParts parts_of(const Slice& slice, double begin, double end) const final;

 protected:
  /// Samples are an eighth of the tool's radius apart, and the region extends by the same distance.
  explicit SampledRegion(double tool_radius_mm) : overlap_mm_{0.125 * tool_radius_mm} {}

  /// Returns whether the condition holds at a place.
  /// @param memory 0 at first, then the value that the last call at a place near by wrote
  [[nodiscard]] virtual bool holds(const Eigen::Vector2d& place, std::size_t& memory) const = 0;

 private:
  class Sampler;

  double overlap_mm_;  ///< Overlap of the region, and also the distance between samples.
};

}  // namespace sim::surface
