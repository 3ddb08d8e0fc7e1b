#pragma once

#include <type_traits>

namespace cnc::contour {

/// The argument at which a search found the least value of a function, and that value.
struct LeastValue {
  double at = 0.0;
  double value = 1.0e30;
};

/// Range and effort of a search.
struct SearchRange {
  double low = 0.0;
  double high = 1.0;
  /// Number of evenly spread evaluations, including both ends of the range; at least 2. If both
  /// ends are equal, there is one evaluation.
  int looks = 8;
  int steps = 20;  ///< Number of steps of the golden section around the best evaluation.
};

/// Returns the least value of a function with one valley. If there are several valleys, returns the
/// deepest valley that the evenly spread evaluations show. The search ends early at the first value
/// that is at most `enough`. The function may accept a bound as a second argument. If its value
/// exceeds the bound, it may return any other value above the bound; the result of the search is
/// the same.
template <typename Function>
[[nodiscard]] LeastValue least_value(const SearchRange& range,
                                     double enough,
                                     const Function& function) {
  constexpr double kGolden = 0.61803398874989485;
  const double stride = (range.high - range.low) / static_cast<double>(range.looks - 1);
  constexpr double kNoBound = 1.0e30;
  LeastValue best{.at = range.low};
  const auto look = [&](double at, double bound) {
    double value = 0.0;
    if constexpr (std::is_invocable_v<Function, double, double>) {
      value = function(at, bound);
    } else {
      value = function(at);
    }
    if (value < best.value) best = {.at = at, .value = value};
    return value;
  };
  if (range.high == range.low) {
    look(range.low, kNoBound);
    return best;
  }
  for (int i = 0; i < range.looks && best.value > enough; ++i) {
    look(range.low + stride * static_cast<double>(i), best.value);
  }
  double low = best.at - stride > range.low ? best.at - stride : range.low;
  double high = best.at + stride < range.high ? best.at + stride : range.high;
  double left = high - kGolden * (high - low);
  double right = low + kGolden * (high - low);
  double at_left = best.value > enough ? look(left, kNoBound) : 0.0;
  double at_right = best.value > enough ? look(right, at_left) : 0.0;
  for (int i = 0; i < range.steps && best.value > enough; ++i) {
    if (at_left < at_right) {
      high = right;
      right = left;
      at_right = at_left;
      left = high - kGolden * (high - low);
      at_left = look(left, at_right);
    } else {
      low = left;
      left = right;
      at_left = at_right;
      right = low + kGolden * (high - low);
      at_right = look(right, at_left);
    }
  }
  return best;
}

}  // namespace cnc::contour
