#pragma once

#include <algorithm>

#include "host-sim/surface/path/region/milled_region.hpp"

namespace sim::surface {

/// Returns whether a point along a slice is in one of its parts.
[[nodiscard]] inline bool has(const SliceParts& parts, double along) {
  return std::ranges::any_of(
      parts, [along](const auto& part) { return part.first <= along && along <= part.second; });
}

}  // namespace sim::surface
