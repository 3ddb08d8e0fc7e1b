#include "planner/motion/lookahead/spans.hpp"

#include <algorithm>

#include "planner/motion/lookahead/direction_limits.hpp"
#include "planner/motion/lookahead/many_direction_limits.hpp"

namespace cnc::motion {

Spans::Spans(const Block& block, const Limits& limits, const TimeWindow& window, Grid grid)
    : line_{block, limits, window},
      boundaries_{block},
      arc_limits_{block, boundaries_.arc(), limits, line_} {
  if (block.turns()) divide_arc(grid);
  // NOLINTNEXTLINE(clang-analyzer-optin.cplusplus.UninitializedObject): ArcAxes has all values.
  if (!window.filters()) return;
  zones_.take(block);
  boundaries_.cut_at_zones(zones_.head(), zones_.tail());
}

void Spans::divide_arc(Grid grid) {
  const ArcShape& arc = boundaries_.arc();
  int split = 1;
  if (grid == Grid::kFine && !line_.window().filters()) {
    split = ArcGrid::finest_split(arc, arc_limits_.shortest_time(arc, boundaries_.length()));
  }
  boundaries_.divide(arc_limits_.many_directions() ? ArcGrid::of_equal_spans(arc)
                                                   : ArcGrid::at_multiples(arc, split));
  arc_limits_.leave_margin(boundaries_.grid().spacing());
}

LimitZone Spans::zone_on(int span) const {
  if (!line_.window().filters()) return {};
  return zones_.between(boundary(span), boundary(span + 1), boundaries_.length());
}

float Spans::greatest_acceleration() const {
  const ArcShape& arc = boundaries_.arc();
  if (!arc.turns()) return line_.acceleration();
  return std::min(line_.acceleration(), arc_limits_.max_acceleration() / arc.plane_share());
}

LimitZone Spans::zone(float cap_square, float reachable_square) const {
  LimitZone zone{.speed_square = cap_square, .acceleration = line_.acceleration()};
  if (boundaries_.arc().turns()) {
    zone.acceleration = std::min(zone.acceleration, arc_limits_.plane_acceleration());
    zone.turning = arc_limits_.turning_along_path(boundaries_.arc());
  }
  zone.length = line_.reach_within(cap_square, reachable_square);
  return zone;
}

/// Returns the directions in which the limits of a span hold: from `from` to `to` or, under a time
/// window, all directions of the arc within the window's reach of the span.
DirectionRange Spans::directions_around(int span, const Place& from, const Place& to) const {
  if (arc_limits_.many_directions()) return {};
  if (arc_limits_.reach() > 0.0F) return {angle_before(span), angle_behind(span)};
  return {from, to};
}

float Spans::speed_limit_square(int span, const Place& from, const Place& to) const {
  const ArcShape& arc = boundaries_.arc();
  if (!arc.turns()) return line_.speed_square();
  const bool turning_limits = !line_.window().filters();
  return arc_limits_.speed_square(arc, directions_around(span, from, to), turning_limits);
}

float Spans::steepest(int span,
                      const Place& from,
                      const Place& to,
                      const SpeedChange& change) const {
  float most = line_.acceleration();
  if (line_.window().filters()) most = steepest_in(zone_on(span), most, change, window_s());
  if (!boundaries_.arc().turns()) return most;
  if (arc_limits_.many_directions()) return steepest_in_many_directions(span, most, change);
  return steepest_in_directions(span, from, to, most, change);
}

float Spans::steepest_in_many_directions(int span, float most, const SpeedChange& change) const {
  const DirectionBox box{angle_before(span), angle_behind(span), arc_limits_.axes()};
  const ManyDirectionLimits limits{boundaries_.arc(), arc_limits_, box, change, window_s()};
  return limits.steepest(most);
}

float Spans::steepest_in_directions(
    int span, const Place& from, const Place& to, float most, const SpeedChange& change) const {
  const DirectionLimits limits{boundaries_.arc(), arc_limits_, change};
  if (!line_.window().filters()) return limits.between(from, to, most);
  const float before = angle_before(span);
  const float behind = angle_behind(span);
  most = limits.within_jerk({before, behind}, most, window_s());
  for (const Place& place : {from, to, sin_cos(before), sin_cos(behind)}) {
    most = limits.at_both_speeds(place, most);
  }
  return most;
}

}  // namespace cnc::motion
