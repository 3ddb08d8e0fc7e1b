#pragma once

#include "host-sim/cut/plan.hpp"
#include "planner/order/rapid_time.hpp"

namespace sim::cut {

/// Returns the least time of a straight rapid, s. Acceleration is ignored.
[[nodiscard]] double min_time(const Place& from,
                              const Place& to,
                              const cnc::order::RapidLimits& limits);

/// Returns the least time of a stroke, s, with its dwell. The stroke is driven at the feed of its
/// layer. A pierce takes at least its set time.
[[nodiscard]] double min_time(const Stroke& stroke, const LayerPlan& layer);

/// Returns the programmed feed of a stroke, mm/s. It is the feed of the layer. A pierce has a lower
/// feed if it would otherwise take less than its set time.
[[nodiscard]] double feed_of(const Stroke& stroke, const LayerPlan& layer);

}  // namespace sim::cut
