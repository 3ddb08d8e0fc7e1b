#pragma once

#include <algorithm>

#include "planner/motion/block/limits.hpp"
#include "planner/motion/lookahead/time_window.hpp"

namespace cnc::motion {

/// Conditions of a plan other than the limits of the machine and the path: overrides and time
/// window.
struct PlanTerms {
  Overrides overrides{};
  /// Greatest overrides since the last rest. The lengths of limit zones follow from these
  /// overrides, because a block may still be left with the speed that they allowed.
  Overrides greatest{};
  TimeWindow window{};
};

/// Return the lower and the higher of two overrides, for the feed and for rapids separately.
[[nodiscard]] inline Overrides lesser_pace(const Overrides& a, const Overrides& b) {
  return {.feed = std::min(a.feed, b.feed), .rapid = std::min(a.rapid, b.rapid)};
}
[[nodiscard]] inline Overrides greater_pace(const Overrides& a, const Overrides& b) {
  return {.feed = std::max(a.feed, b.feed), .rapid = std::max(a.rapid, b.rapid)};
}
[[nodiscard]] inline bool same_pace(const Overrides& a, const Overrides& b) {
  return a.feed == b.feed && a.rapid == b.rapid;
}

}  // namespace cnc::motion
