#pragma once

#include <algorithm>

#include "planner/motion/block/limits.hpp"
#include "planner/motion/lookahead/time_window.hpp"

namespace cnc::motion {

/// Terms of a plan, besides the machine and the path.
struct PlanTerms {
  Overrides overrides{};
  /// The greatest overrides since the last rest. The limits of a block reach beyond it as far as
  /// these overrides require, because the block may still be left at that speed.
  Overrides greatest{};
  TimeWindow window{};
};

/// Return the lesser and the greater of two overrides, each for feed and for rapids.
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
