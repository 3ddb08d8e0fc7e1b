#include "host-sim/cut/job_clock.hpp"

#include <algorithm>
#include <cmath>

#include "host-sim/knowledge/experiment.hpp"

namespace sim::cut {

double min_time(const Place& from, const Place& to, const cnc::order::RapidLimits& limits) {
  return std::max(std::abs(to.x() - from.x()) / limits.rate_mm_s[0],
                  std::abs(to.y() - from.y()) / limits.rate_mm_s[1]);
}

double min_time(const Stroke& stroke, const LayerPlan& layer) {
  const double feed_mm_min = from_thousandths(layer.condition.cut.speed_um_min);
  const double driven = 60.0 * length_of(stroke) / feed_mm_min;
  const bool is_pierce = stroke.purpose == Purpose::kPierce;
  return stroke.dwell_s + (is_pierce ? std::max(driven, layer.settings.pierce_s) : driven);
}

double feed_of(const Stroke& stroke, const LayerPlan& layer) {
  const double feed = from_thousandths(layer.condition.cut.speed_um_min) / 60.0;
  const bool is_slow = stroke.purpose == Purpose::kPierce && layer.settings.pierce_s > 0.0;
  return is_slow ? std::min(feed, length_of(stroke) / layer.settings.pierce_s) : feed;
}

}  // namespace sim::cut
