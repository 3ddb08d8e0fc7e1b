#pragma once

#include <algorithm>
#include <optional>

#include "host-sim/surface/path/path_heights.hpp"
#include "host-sim/surface/path/slice.hpp"

namespace sim::surface {

/// Computes the heights of a tool's tip over a slice. Successive requests should be for nearby
/// points, because each search begins with the last touched facet.
class SliceHeights {
 public:
  /// @param floor_mm lowest height of the tip; also the tip's height where nothing is under the
  /// tool. Without a floor, the tip has no height at such points.
  /// @pre the heights outlive this object
  SliceHeights(const PathHeights& heights, const Slice& slice, std::optional<double> floor_mm)
      : heights_{&heights}, slice_{slice}, floor_mm_{floor_mm.value_or(cnc::surface::kNoContact)} {}

  [[nodiscard]] const Slice& slice() const { return slice_; }

  /// Returns the height at the distance `along` the slice; cnc::surface::kNoContact if there is no
  /// height.
  [[nodiscard]] double operator()(double along) {
    return std::max(floor_mm_, (*heights_)(slice_.at(along), hint_));
  }

 private:
  const PathHeights* heights_;
  Slice slice_;
  double floor_mm_;
  PathHeights::Hint hint_{};
};

}  // namespace sim::surface
