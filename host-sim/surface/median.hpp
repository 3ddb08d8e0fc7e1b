#pragma once

#include <algorithm>
#include <cstddef>
#include <span>

namespace sim::surface {

/// Returns the middle one of `values`, the upper of two; 0 if there are none. Reorders them; NaN is
/// not allowed.
[[nodiscard]] inline double median_of(std::span<double> values) {
  if (values.empty()) return 0.0;
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

}  // namespace sim::surface
