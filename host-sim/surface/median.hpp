#pragma once

#include <algorithm>
#include <cstddef>
#include <span>

namespace sim::surface {

/// Returns the median of `values`; of two middle values, the upper one; 0 if `values` is empty.
/// Reorders `values`.
/// @pre no value is NaN
[[nodiscard]] inline double median_of(std::span<double> values) {
  if (values.empty()) return 0.0;
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

}  // namespace sim::surface
