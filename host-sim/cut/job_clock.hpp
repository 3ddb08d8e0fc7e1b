#pragma once

#include "host-sim/cut/plan.hpp"

namespace sim::cut {

/// The greatest speeds of rapids, mm/min, above 0.
struct RapidRates {
  double x_mm_min = 10'000.0;
  double y_mm_min = 10'000.0;
};

/// Returns the time that a straight rapid takes at least, s: without acceleration.
[[nodiscard]] double least_time(const Place& from, const Place& to, const RapidRates& rates);

/// Returns the time that a stroke takes at least, s: at the feed of its layer, a pierce as long as
/// it lasts, and its dwell.
[[nodiscard]] double least_time(const Stroke& stroke, const LayerPlan& layer);

}  // namespace sim::cut
