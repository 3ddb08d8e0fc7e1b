#pragma once

#include <algorithm>
#include <optional>

#include "host-sim/surface/path/path_heights.hpp"
#include "host-sim/surface/path/slice.hpp"

namespace sim::surface {

/// The heights of a tool's tip over a slice. Neighbours are asked for one after the other, as each
/// begins with the facet that the last one touched.
class SliceHeights {
 public:
  /// @param floor_mm the tip is never lower, and there where nothing is under the tool; without
  /// one such places have no height. @pre the heights outlive this
  SliceHeights(const PathHeights& heights, const Slice& slice, std::optional<double> floor_mm)
      : heights_{&heights}, slice_{slice}, floor_mm_{floor_mm.value_or(cnc::surface::kNoContact)} {}

  [[nodiscard]] const Slice& slice() const { return slice_; }

  /// Returns the height, cnc::surface::kNoContact where there is none.
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
