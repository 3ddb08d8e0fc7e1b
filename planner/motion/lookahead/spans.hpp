#pragma once

#include <array>
#include <cstddef>
#include <span>

#include "planner/motion/block/axes_in_plane.hpp"
#include "planner/motion/lookahead/time_window.hpp"

namespace cnc::motion {

/// A place on an arc as the acceleration limits see it: the direction of travel in its plane. With
/// path speed v and path acceleration a, axis i accelerates by tangent_i · a + bend_i · v², where
/// the bend is d tangent / d path length. On a line it says nothing.
using Place = SinCos;

/// Which end of a span is known, and which way the speed is to change.
enum class Travel : std::int8_t { kForward = 1, kBackward = -1 };
enum class Change : std::int8_t { kSpeedUp = 1, kSlowDown = -1 };

/// From a place where the speed is known to another within a span.
struct SpeedChange {
  float distance = 0.0F;      ///< mm, in the direction of `travel`.
  float speed_square = 0.0F;  ///< v² where it is known.
  float cap_square = 0.0F;    ///< The greatest v² on the way.
  Travel travel = Travel::kForward;
  Change change = Change::kSpeedUp;
  /// mm over which v² is taken to grow, when what turning leaves is asked for.
  float growing = 0.0F;
};

/// Divides a block into spans on which one acceleration can hold: where zones of its
/// neighbours begin and end; an arc at each multiple of 3.75° of its tangent, too, quarter
/// turns among them, so that in a coordinate plane no axis reverses within a span. Whoever drives
/// the block may ask for a finer grid, which there is without a time window.
///
/// Under a time window the limits of a place hold around it, as far as the arc goes: what is
/// beyond asks for itself, by its zones. On an arc of which the window spans more than 7.5°
/// either way spans are at most 7.5° long, and each keeps the limits of all directions that
/// the window may span around it.
///
/// Only limits are divided here. The path stays one arc.
class Spans {
 public:
  static constexpr int kGridPerTurn = 96;
  static constexpr int kMostEdges = 4;  ///< Of zones, within a block.
  static constexpr int kMostSpans = kGridPerTurn / 2 + 2 + kMostEdges;

  /// The fine grid has up to 16 spans instead of one, at most kMostFineSpans in all, and each span
  /// takes 0.7 ms at least: more is left of limits that change along the arc.
  enum class Grid : std::uint8_t { kUsual, kFine };
  static constexpr int kMostFineSpans = 2 * kGridPerTurn + 2;

  Spans() = default;
  Spans(const Block& block,
        const Limits& limits,
        const TimeWindow& window = {},
        Grid grid = Grid::kUsual);

  [[nodiscard]] int count() const { return count_; }
  /// They are shorter than those of the usual grid.
  [[nodiscard]] bool fine() const { return split_ > 1; }
  [[nodiscard]] const BlockZones& tail() const { return tail_; }
  /// s.
  [[nodiscard]] float window_s() const { return window_.seconds(); }
  /// mm from the start of the block, for boundary 0…count().
  [[nodiscard]] float boundary(int index) const;
  [[nodiscard]] float length_of(int span) const { return boundary(span + 1) - boundary(span); }
  /// Limit of v² inside a span from axis rates, step rates, centripetal
  /// acceleration and jerk, before any feed.
  [[nodiscard]] float speed_limit_square(int span) const {
    return speed_limit_square(span, place_at_boundary(span), place_at_boundary(span + 1));
  }
  /// The same for who knows its ends already.
  [[nodiscard]] float speed_limit_square(int span, const Place& from, const Place& to) const;
  /// Limit of v² from neighbours' zones, their feeds included.
  [[nodiscard]] float zone_speed_square(int span) const { return zone_on(span).speed_square; }

  /// mm/s² along the path, at most; under a window.
  [[nodiscard]] float greatest_acceleration() const;
  /// What this block asks of its neighbours, where v² is at most `cap_square` on it and in
  /// what it asks for, and on it also at most `reachable_square`.
  [[nodiscard]] LimitZone zone(float cap_square, float reachable_square) const;

  [[nodiscard]] Place place_at_boundary(int index) const;
  [[nodiscard]] Place place_at(float distance) const;

  /// The greatest rate of change of speed, mm/s² ≥ 0, constant from `from` to
  /// `to`, for which no axis exceeds its acceleration (or, under a window, its
  /// jerk) at either end nor would if it stood still there.
  /// @param span that both lie in.
  [[nodiscard]] float steepest(int span,
                               const Place& from,
                               const Place& to,
                               const SpeedChange& change) const;

 private:
  /// An axis of the plane in which an arc turns.
  struct ArcAxis {
    AxisInPlane in_plane{};
    float acceleration = 0.0F;
    float rate = 0.0F;
  };
  class DirectionBox;

  void lay_out_arc(const Block& block, const Limits& limits, Grid grid);
  float take_axes(const Block& block, const Limits& limits);
  void lay_out_turning(float least, float reachable_square);
  [[nodiscard]] int finest_split() const;
  void lay_out_grid();
  void lay_out_edges();
  void add_edge(float distance);
  [[nodiscard]] float own_boundary(int own) const;
  [[nodiscard]] float own_angle(int own) const;
  [[nodiscard]] int edges_before(int index) const;
  [[nodiscard]] bool is_edge(int index) const;
  [[nodiscard]] float angle_of(int index) const;
  [[nodiscard]] std::span<const ArcAxis> arc_axes() const {
    return {arc_axes_.data(), arc_axis_count_};
  }
  [[nodiscard]] LimitZone zone_on(int span) const;
  [[nodiscard]] float angle_before(int span) const;
  [[nodiscard]] float angle_behind(int span) const;
  [[nodiscard]] DirectionRange directions_around(int span,
                                                 const Place& from,
                                                 const Place& to) const;
  [[nodiscard]] AxisShares shares_of(const ArcAxis& axis, const DirectionRange& directions) const;
  [[nodiscard]] float reach_within(float cap_square, float reachable_square) const;
  [[nodiscard]] float within_turning(int span, float most, const SpeedChange& change) const;
  [[nodiscard]] float within_jerk(const DirectionRange& directions,
                                  float most,
                                  const SpeedChange& change) const;
  [[nodiscard]] float within_jerk_at(float speed,
                                     float most,
                                     const AxisArray<AxisShares>& shares) const;

  int count_ = 1;      ///< Of spans.
  int own_count_ = 1;  ///< The same without edges of zones.
  int edge_count_ = 0;
  float length_ = 0.0F;
  float straight_acceleration_ = 0.0F;  ///< Limit set by the axes whose direction is constant.
  float straight_speed_square_ = 0.0F;
  float all_axes_ = 0.0F;  ///< mm/s² that no block asks for more than; under a window.
  TimeWindow window_{};
  BlockZones head_{};
  BlockZones tail_{};
  std::array<float, kMostEdges> edges_{};       ///< mm from the start, in order.
  std::array<int, kMostEdges> edge_indices_{};  ///< Of the boundaries that they are.

  // Of an arc.
  bool uniform_ = false;      ///< The window spans many directions.
  int split_ = 1;             ///< Spans in 3.75°.
  float grid_angle_ = 0.0F;   ///< Radians from one boundary to the next.
  int first_grid_ = 0;        ///< Grid index of boundary 1.
  float start_angle_ = 0.0F;  ///< Of the tangent, mirrored so that it grows.
  float sweep_ = 0.0F;
  float side_ = 1.0F;  ///< +1 counter-clockwise.
  float mm_per_radian_ = 0.0F;
  float plane_share_ = 0.0F;
  float reach_ = 0.0F;               ///< Radians either way that the window spans.
  float curvature_ = 0.0F;           ///< Of the plane circle, 1/mm.
  Turning turning_{};                ///< Within the plane.
  float plane_acceleration_ = 0.0F;  ///< In all directions of the arc, with the turning.
  float most_acceleration_ = 0.0F;   ///< At most, if it did not turn.
  AxisArray<ArcAxis> arc_axes_{};
  std::size_t arc_axis_count_ = 0;
};

}  // namespace cnc::motion
