#pragma once

#include <cstdint>

#include "planner/motion/lookahead/arc_limits.hpp"
#include "planner/motion/lookahead/line_limits.hpp"
#include "planner/motion/lookahead/neighbour_zones.hpp"
#include "planner/motion/lookahead/span_boundaries.hpp"
#include "planner/motion/lookahead/speed_change.hpp"

namespace cnc::motion {

/// Divides a block into spans on which one acceleration can hold, see SpanBoundaries, and finds the
/// limits of each span. Only limits are divided here. The path stays one arc.
///
/// Under a time window, the limits of a position hold around it, up to the ends of the arc. In the
/// neighbouring blocks they hold as zones. If the window spans more than 7.5° to either side, the
/// arc has equal spans of at most 3.75°. Each of these spans keeps the limits of all directions
/// that the window may span around it.
class Spans {
 public:
  static constexpr int kGridPerTurn = ArcGrid::kPerTurn;
  static constexpr int kMaxSpans = ArcGrid::kMaxSpans + ZoneEdges::kMax;

  /// The fine grid has up to 16 spans in place of one, and at most kMaxFineSpans in all. Each of
  /// its spans takes at least 0.7 ms. It can use more of limits that change along the arc. With a
  /// time window there is no fine grid.
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
  /// Returns the zones of later blocks.
  [[nodiscard]] const BlockZones& tail() const { return zones_.tail(); }
  /// Returns the time window in s; 0 without one.
  [[nodiscard]] float window_s() const { return line_.window().seconds(); }
  /// Returns the distance of a boundary, 0…count(), from the start of the block, in mm.
  [[nodiscard]] float boundary(int index) const { return boundaries_.distance(index); }
  [[nodiscard]] float length_of(int span) const { return boundary(span + 1) - boundary(span); }
  /// Returns the limit of v² inside a span from axis rates, step rates, centripetal
  /// acceleration and jerk, before any feed.
  [[nodiscard]] float speed_limit_square(int span) const {
    return speed_limit_square(span, place_at_boundary(span), place_at_boundary(span + 1));
  }
  /// Returns the limit of v² inside a span for a caller that has the places of the span's ends
  /// already.
  [[nodiscard]] float speed_limit_square(int span, const Place& from, const Place& to) const;
  /// Returns the limit of v² from neighbours' zones, their feeds included.
  [[nodiscard]] float zone_speed_square(int span) const { return zone_on(span).speed_square; }

  /// Returns the greatest acceleration along the path, in mm/s². @pre there is a time window
  [[nodiscard]] float greatest_acceleration() const;
  /// Returns the zone that this block imposes on its neighbours.
  /// @param cap_square the greatest v² on the block and in its zone
  /// @param reachable_square the greatest v² on the block
  [[nodiscard]] LimitZone zone(float cap_square, float reachable_square) const;

  [[nodiscard]] Place place_at_boundary(int index) const { return boundaries_.place(index); }
  [[nodiscard]] Place place_at(float distance) const {
    return boundaries_.arc().place_at(distance);
  }

  /// Returns the greatest rate of change of speed, in mm/s² ≥ 0, that may hold from `from` to `to`.
  /// At either end no axis exceeds its acceleration (or, under a window, its jerk), nor would it at
  /// speed 0.
  /// @param span the span in which both positions lie
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
  NeighbourZones zones_;  ///< Empty without a time window.
};

}  // namespace cnc::motion
