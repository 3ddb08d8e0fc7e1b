#pragma once

#include <Eigen/Core>
#include <memory>
#include <utility>
#include <vector>

#include "host-sim/surface/path/slice.hpp"

namespace sim::surface {

/// Parts of a slice as begin and end along the slice, mm. They are in order and do not touch.
using SliceParts = std::vector<std::pair<double, double>>;

/// The part of the plan that a path mills. All threads may call the const functions at once.
class MilledRegion {
 public:
  MilledRegion(const MilledRegion&) = delete;
  MilledRegion& operator=(const MilledRegion&) = delete;
  virtual ~MilledRegion() = default;

  /// Returns the parts of a slice between `begin` and `end`, mm, that are milled.
  [[nodiscard]] virtual SliceParts parts_of(const Slice& slice, double begin, double end) const = 0;

  /// Returns whether links must stay in the region, as in a drawn one. Other regions only state
  /// where milling is worthwhile: a link outside them never cuts into the surface either.
  [[nodiscard]] virtual bool bars_links() const { return false; }

 protected:
  MilledRegion() = default;
};

/// Regions that all limit a path. Without regions the path is not limited.
using MilledRegions = std::vector<std::shared_ptr<const MilledRegion>>;

/// Returns whether a link may lead over a slice: the whole slice is in all regions that bar links.
[[nodiscard]] bool lets_link_through(const MilledRegions& regions, const Slice& slice);

/// Returns those pieces of the parts of a slice that lie in all regions.
[[nodiscard]] SliceParts common_parts(const MilledRegions& regions,
                                      const Slice& slice,
                                      SliceParts parts);

/// Sorts parts, and joins parts that overlap or whose gap is at most `gap_mm`.
void join_parts(SliceParts& parts, double gap_mm);

}  // namespace sim::surface
