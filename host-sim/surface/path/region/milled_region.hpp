#pragma once

#include <Eigen/Core>
#include <memory>
#include <utility>
#include <vector>

#include "host-sim/surface/path/slice.hpp"

namespace sim::surface {

/// Parts of a slice. Each is given by the positions of its start and end along the slice, mm. The
/// parts are in order and do not touch.
using SliceParts = std::vector<std::pair<double, double>>;

/// A region in plan (in XY) to which milling is limited. Several threads may call the const
/// functions at the same time.
class MilledRegion {
 public:
  MilledRegion(const MilledRegion&) = delete;
  MilledRegion& operator=(const MilledRegion&) = delete;
  virtual ~MilledRegion() = default;

  /// Returns the parts of a slice between `begin` and `end`, mm, that are milled.
  [[nodiscard]] virtual SliceParts parts_of(const Slice& slice, double begin, double end) const = 0;

  /// Returns whether links must stay in the region, as in a drawn region. Other regions only limit
  /// milling to useful areas, and a link outside of them does no harm.
  [[nodiscard]] virtual bool bars_links() const { return false; }

 protected:
  MilledRegion() = default;
};

/// Regions that limit a path: the path mills only in their intersection. Without regions, the path
/// is not limited.
using MilledRegions = std::vector<std::shared_ptr<const MilledRegion>>;

/// Returns whether a link may lead over a slice. It may if the complete slice is in all regions
/// that bar links outside.
[[nodiscard]] bool lets_link_through(const MilledRegions& regions, const Slice& slice);

/// Returns the pieces of the given parts of a slice that are in all regions.
[[nodiscard]] SliceParts common_parts(const MilledRegions& regions,
                                      const Slice& slice,
                                      SliceParts parts);

/// Sorts parts. Joins parts that overlap, and parts with a gap of at most `gap_mm` between them.
void join_parts(SliceParts& parts, double gap_mm);

}  // namespace sim::surface
