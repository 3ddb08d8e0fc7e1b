#pragma once

#include <Eigen/Core>
#include <memory>
#include <utility>
#include <vector>

#include "host-sim/surface/path/slice.hpp"

namespace sim::surface {

/// Parts of a slice as begin and end along it, mm: in order, and apart from each other.
using SliceParts = std::vector<std::pair<double, double>>;

/// The part of the plan that a path mills. Any thread may ask, as nothing changes.
class MilledRegion {
 public:
  MilledRegion(const MilledRegion&) = delete;
  MilledRegion& operator=(const MilledRegion&) = delete;
  virtual ~MilledRegion() = default;

  /// Returns the parts of a slice between `begin` and `end`, mm, that are milled.
  [[nodiscard]] virtual SliceParts parts_of(const Slice& slice, double begin, double end) const = 0;

  /// Returns whether links stay in the region, as in one that is drawn. Others only say where it is
  /// worth to mill: a link beside them never cuts in either.
  [[nodiscard]] virtual bool bars_links() const { return false; }

 protected:
  MilledRegion() = default;
};

/// Regions of which each limits a path; without any it goes everywhere.
using MilledRegions = std::vector<std::shared_ptr<const MilledRegion>>;

/// Returns whether a link may lead over a slice: all of it is in the regions that bar links.
[[nodiscard]] bool lets_link_through(const MilledRegions& regions, const Slice& slice);

/// Returns what of the parts of a slice lies in all regions.
[[nodiscard]] SliceParts common_parts(const MilledRegions& regions,
                                      const Slice& slice,
                                      SliceParts parts);

/// Sorts parts and joins those that overlap or whose gap is `gap_mm` at most.
void join_parts(SliceParts& parts, double gap_mm);

}  // namespace sim::surface
