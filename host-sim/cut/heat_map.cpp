#include "host-sim/cut/heat_map.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace sim::cut {

namespace {
constexpr double kStretchesInReach = 16.0;
}  // namespace

HeatMap::HeatMap(double distance_mm, double lasts_s)
    : step_mm_{distance_mm / kStretchesInReach},
      reach_mm_{distance_mm + 0.5 * step_mm_},
      lasts_s_{lasts_s} {}

std::int64_t HeatMap::cell_of(double mm) const {
  return static_cast<std::int64_t>(std::floor(mm / reach_mm_));
}

void HeatMap::add(const Stroke& stroke, double begin_s, double end_s) {
  const double stretches = std::max(1.0, std::ceil(length_of(stroke) / step_mm_));
  for (double i = 0.0; i < stretches; i += 1.0) {
    const Place place = place_at(stroke, (i + 0.5) / stretches);
    const double time = begin_s + (end_s - begin_s) * (i + 1.0) / stretches;
    cells_[key_of(cell_of(place.x()), cell_of(place.y()))].push_back({place, time});
  }
}

double HeatMap::cool_from(const Place& place, double now_s) const {
  double from = -std::numeric_limits<double>::infinity();
  for (std::int64_t column = cell_of(place.x()) - 1; column <= cell_of(place.x()) + 1; ++column) {
    for (std::int64_t row = cell_of(place.y()) - 1; row <= cell_of(place.y()) + 1; ++row) {
      const auto cell = cells_.find(key_of(column, row));
      if (cell == cells_.end()) continue;
      const std::vector<Spot>& spots = cell->second;
      for (std::size_t i = spots.size(); i-- > 0;) {
        const double cool = spots[i].time_s + lasts_s_;
        // The earlier spots of the cell are older, so they are cool even earlier.
        if (cool <= std::max(now_s, from)) break;
        if (drawing::distance(spots[i].place, place) < reach_mm_) from = cool;
      }
    }
  }
  return from;
}

}  // namespace sim::cut
