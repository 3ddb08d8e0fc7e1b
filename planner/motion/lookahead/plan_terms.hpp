#pragma once

#include <algorithm>

#include "planner/motion/block/limits.hpp"
#include "planner/motion/lookahead/time_window.hpp"

namespace cnc::motion {

/// What a plan is made for, besides the machine and the path.
struct PlanTerms {
  Overrides overrides{};
  /// The greatest since the last rest: as far as these ask for, the limits of a
  /// block reach beyond it, for it may yet be left as fast.
  Overrides greatest{};
  TimeWindow window{};
};

/// The lesser and the greater of both, of feed and of rapids.
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
