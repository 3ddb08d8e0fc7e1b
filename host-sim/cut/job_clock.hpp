#pragma once

#include "host-sim/cut/plan.hpp"
#include "planner/order/rapid_time.hpp"

namespace sim::cut {

/// Returns the time that a straight rapid takes at least, s: without acceleration.
[[nodiscard]] double least_time(const Place& from,
                                const Place& to,
                                const cnc::order::RapidLimits& limits);

/// Returns the time that a stroke takes at least, s: at the feed of its layer, a pierce as long as
/// it lasts, and its dwell.
[[nodiscard]] double least_time(const Stroke& stroke, const LayerPlan& layer);

/// Returns the feed at which a stroke is programmed, mm/s: that of its layer, or so low that a
/// pierce takes its time.
[[nodiscard]] double feed_of(const Stroke& stroke, const LayerPlan& layer);

}  // namespace sim::cut
