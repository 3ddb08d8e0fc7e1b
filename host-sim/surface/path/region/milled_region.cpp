#include "host-sim/surface/path/region/milled_region.hpp"

#include <algorithm>

namespace sim::surface {

SliceParts common_parts(const MilledRegions& regions, const Slice& slice, SliceParts parts) {
  for (const auto& region : regions) {
    SliceParts common;
    for (const auto& [begin, end] : parts) {
      const SliceParts milled = region->parts_of(slice, begin, end);
      common.insert(common.end(), milled.begin(), milled.end());
    }
    parts = std::move(common);
  }
  return parts;
}

bool lets_link_through(const MilledRegions& regions, const Slice& slice) {
  constexpr double kWithin = 1.0e-6;
  return std::ranges::all_of(regions, [&slice](const auto& region) {
    if (!region->bars_links()) return true;
    const SliceParts parts = region->parts_of(slice, 0.0, slice.length);
    return parts.size() == 1 && parts[0].first <= kWithin &&
           parts[0].second >= slice.length - kWithin;
  });
}

void join_parts(SliceParts& parts, double gap_mm) {
  if (parts.empty()) return;
  std::ranges::sort(parts);
  std::size_t last = 0;
  for (std::size_t i = 1; i < parts.size(); ++i) {
    if (parts[i].first <= parts[last].second + gap_mm) {
      parts[last].second = std::max(parts[last].second, parts[i].second);
    } else {
      parts[++last] = parts[i];
    }
  }
  parts.resize(last + 1);
}

}  // namespace sim::surface
