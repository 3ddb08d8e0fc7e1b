#pragma once

#include <memory>
#include <vector>

#include "host-sim/contour/contour_offset.hpp"
#include "host-sim/pocket/owned_area.hpp"
#include "host-sim/surface/path/region/milled_region.hpp"

namespace sim::surface {

/// The region inside drawn contours, including the contours' lines: all points that are in at least
/// one of several areas.
class DrawnRegion final : public MilledRegion {
 public:
  /// @param areas contours with their area on the left, whose loops do not cross. Areas may overlap
  explicit DrawnRegion(const std::vector<Contour>& areas);

  /// Returns the parts of the slice, from its exact intersections with lines and arcs. Parts
  /// shorter than 1e-6 mm are left out.
  [[nodiscard]] SliceParts parts_of(const Slice& slice, double begin, double end) const override;
  [[nodiscard]] bool bars_links() const override { return true; }

 private:
  std::vector<std::unique_ptr<const pocket::OwnedArea>> areas_;
};

}  // namespace sim::surface
