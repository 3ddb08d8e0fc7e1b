#pragma once

#include "host-sim/surface/path/region/milled_region.hpp"

namespace sim::surface {

/// The region in which a condition holds, extended on all sides by an overlap. Borders are found by
/// bisection to 1e-6 mm, on five parallel slices within the overlap.
class SampledRegion : public MilledRegion {
 public:
  /// Returns the parts of the slice. Gaps of up to twice the overlap are closed. No part is shorter
  /// than twice the overlap, except at the ends of the slice. A feature between two samples is not
  /// found.
  [[nodiscard]] SliceParts parts_of(const Slice& slice, double begin, double end) const final;

 protected:
  /// Sets the overlap and the distance between samples to an eighth of the tool's radius.
  explicit SampledRegion(double tool_radius_mm) : overlap_mm_{0.125 * tool_radius_mm} {}

  /// Returns whether the condition holds at a place.
  /// @param memory 0 at the first call, then the value that the last call at a nearby point wrote
  [[nodiscard]] virtual bool holds(const Eigen::Vector2d& place, std::size_t& memory) const = 0;

 private:
  class Sampler;

  double overlap_mm_;  ///< Overlap of the region, which is also the distance between samples.
};

}  // namespace sim::surface
