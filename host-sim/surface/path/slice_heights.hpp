#pragma once

#include <algorithm>
#include <optional>

#include "host-sim/surface/path/path_heights.hpp"
#include "host-sim/surface/path/slice.hpp"

namespace sim::surface {

/// The heights of a tool's tip over a slice. Heights should be requested from neighbour to
/// neighbour, because each search begins with the facet that was touched last.
class SliceHeights {
 public:
  /// @param floor_mm lowest height of the tip, and its height where nothing is under the tool.
  /// Without a floor such places have no height.
  /// @pre the heights outlive this object
  SliceHeights(const PathHeights& heights, const Slice& slice, std::optional<double> floor_mm)
      : heights_{&heights}, slice_{slice}, floor_mm_{floor_mm.value_or(cnc::surface::kNoContact)} {}

  [[nodiscard]] const Slice& slice() const { return slice_; }

  /// Returns the height; cnc::surface::kNoContact if the place has none.
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
