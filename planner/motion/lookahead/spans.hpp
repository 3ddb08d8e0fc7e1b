#pragma once

#include <cstdint>

#include "planner/motion/lookahead/arc_limits.hpp"
#include "planner/motion/lookahead/line_limits.hpp"
#include "planner/motion/lookahead/neighbour_zones.hpp"
#include "planner/motion/lookahead/span_boundaries.hpp"
#include "planner/motion/lookahead/speed_change.hpp"

namespace cnc::motion {

/// Divides a block into spans on which one acceleration can hold (see SpanBoundaries), and computes
/// the limits of each span. Only the limits are divided; the path stays one arc.
///
/// Under a time window, the limits of a position also hold at some distance before and after it
/// (the reach of the window). On an arc, this distance is cut off at the ends of the arc. In the
/// neighbouring blocks, the limits hold as limit zones. If the reach is more than 7.5° of the arc,
/// the arc has equal spans of at most 3.75°. Then each span keeps the limits of all directions
/// within the reach.
class Spans {
 public:
  static constexpr int kGridPerTurn = ArcGrid::kPerTurn;
  static constexpr int kMaxSpans = ArcGrid::kMaxSpans + ZoneEdges::kMax;

  /// The fine grid divides each span of the usual grid into up to 16 spans, with at most
  /// kMaxFineSpans in total. Each of these spans takes at least 0.7 ms. On the fine grid, the speed
  /// follows limits that change along the arc more closely. Under a time window there is no fine
  /// grid.
  enum class Grid : std::uint8_t { kUsual, kFine };
  static constexpr int kMaxFineSpans = ArcGrid::kMaxFineSpans;

  Spans() = default;
  Spans(const Block& block,
        const Limits& limits,
        const TimeWindow& window = {},
        Grid grid = Grid::kUsual);

  [[nodiscard]] int count() const { return boundaries_.count(); }
  /// Checks whether the spans are shorter than those of the usual grid.
  [[nodiscard]] bool fine() const { return boundaries_.grid().fine(); }
  /// Returns the limit zones of later blocks that reach into this block.
  [[nodiscard]] const BlockZones& tail() const { return zones_.tail(); }
  /// Returns the length of the time window in s; 0 without a time window.
  [[nodiscard]] float window_s() const { return line_.window().seconds(); }
  /// Returns the distance of a boundary, 0…count(), from the start of the block, in mm.
  [[nodiscard]] float boundary(int index) const { return boundaries_.distance(index); }
  [[nodiscard]] float length_of(int span) const { return boundary(span + 1) - boundary(span); }
  /// Returns the limit of v² within a span from axis rates, step rates, centripetal acceleration
  /// and jerk. The feed is not considered.
  [[nodiscard]] float speed_limit_square(int span) const {
    return speed_limit_square(span, place_at_boundary(span), place_at_boundary(span + 1));
  }
  /// Returns the limit of v² within a span as the function above, for callers that have already
  /// computed the directions at the span's ends.
  /// @param from, to directions at the start and at the end of the span
  [[nodiscard]] float speed_limit_square(int span, const Place& from, const Place& to) const;
  /// Returns the limit of v² from the limit zones of neighbouring blocks. It includes the feeds of
  /// these blocks.
  [[nodiscard]] float zone_speed_square(int span) const { return zone_on(span).speed_square; }

  /// Returns the greatest acceleration along the path anywhere on the block, in mm/s². @pre there
  /// is a time window
  [[nodiscard]] float greatest_acceleration() const;
  /// Returns the limit zone that this block imposes on its neighbours.
  /// @param cap_square greatest v² on the block and in its zone
  /// @param reachable_square greatest v² with which the block may be left
  [[nodiscard]] LimitZone zone(float cap_square, float reachable_square) const;

  [[nodiscard]] Place place_at_boundary(int index) const { return boundaries_.place(index); }
  [[nodiscard]] Place place_at(float distance) const {
    return boundaries_.arc().place_at(distance);
  }

  /// Returns the greatest magnitude of acceleration along the path, in mm/s², that may hold from
  /// `from` to `to`. At both positions, no axis exceeds its acceleration limit nor, under a time
  /// window, its jerk limit. The same is true at speed 0.
  /// @param span the span that contains both positions
  [[nodiscard]] float steepest(int span,
                               const Place& from,
                               const Place& to,
                               const SpeedChange& change) const;

 private:
  void divide_arc(Grid grid);
  [[nodiscard]] LimitZone zone_on(int span) const;
  [[nodiscard]] float angle_before(int span) const {
    return boundaries_.angle_before(span, arc_limits_.reach());
  }
  [[nodiscard]] float angle_behind(int span) const {
    return boundaries_.angle_behind(span, arc_limits_.reach());
  }
  [[nodiscard]] DirectionRange directions_around(int span,
                                                 const Place& from,
                                                 const Place& to) const;
  [[nodiscard]] float steepest_in_many_directions(int span,
                                                  float most,
                                                  const SpeedChange& change) const;
  [[nodiscard]] float steepest_in_directions(
      int span, const Place& from, const Place& to, float most, const SpeedChange& change) const;

  LineLimits line_;
  SpanBoundaries boundaries_;
  ArcLimits arc_limits_;
  /// Zones of neighbours that reach into the block; empty without a time window.
  NeighbourZones zones_;
};

}  // namespace cnc::motion
