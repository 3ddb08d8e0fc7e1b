#pragma once

#include "host-sim/cut/plan.hpp"
#include "planner/order/rapid_time.hpp"

namespace sim::cut {

/// Returns the least time of a straight rapid, s: without acceleration.
[[nodiscard]] double min_time(const Place& from,
                              const Place& to,
                              const cnc::order::RapidLimits& limits);

/// Returns the least time of a stroke, s: at the feed of its layer, for a pierce its set time, with
/// the dwell added.
[[nodiscard]] double min_time(const Stroke& stroke, const LayerPlan& layer);

/// Returns the programmed feed of a stroke, mm/s: the feed of its layer, or for a pierce a lower
/// feed at which the pierce takes its set time.
[[nodiscard]] double feed_of(const Stroke& stroke, const LayerPlan& layer);

}  // namespace sim::cut
