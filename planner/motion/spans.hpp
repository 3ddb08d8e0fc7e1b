#pragma once

#include "planner/motion/block.hpp"
#include "planner/motion/limits.hpp"

namespace cnc::motion {

/// A place on a block as the acceleration limits see it: with path speed v and
/// path acceleration a, axis i accelerates by tangent_i · a + bend_i · v².
struct Place {
  float tangent_first = 0.0F;  ///< Along the two axes of the plane.
  float tangent_second = 0.0F;
  float bend_first = 0.0F;  ///< d tangent / d path length, 1/mm.
  float bend_second = 0.0F;
};

/// Which end of a span is known, and which way the speed is to change.
enum class Travel : std::int8_t { kForward = 1, kBackward = -1 };
enum class Change : std::int8_t { kSpeedUp = 1, kSlowDown = -1 };

/// Divides a block into spans on which one acceleration can hold: a straight
/// block is one span; an arc has a boundary at each multiple of 3.75° of its
/// tangent, quarter turns among them, so that within a span no axis reverses.
///
/// Only limits are divided here. The path stays one arc.
class Spans {
 public:
  static constexpr int kGridPerTurn = 96;
  static constexpr int kMostSpans = kGridPerTurn / 2 + 2;

  Spans() = default;
  Spans(const Block& block, const Limits& limits);

  [[nodiscard]] int count() const { return count_; }
  /// mm from the start of the block, for boundary 0…count().
  [[nodiscard]] float boundary(int index) const;
  [[nodiscard]] float length_of(int span) const { return boundary(span + 1) - boundary(span); }
  /// Limit of v² inside a span from axis rates, step rates and centripetal
  /// acceleration, before any feed.
  [[nodiscard]] float speed_limit_square(int span) const;

  /// Whether an axis of the plane reverses at an end of the span or next to it,
  /// so that its speed changes there by more than itself.
  [[nodiscard]] bool near_reversal(int span) const;

  [[nodiscard]] Place place_at_boundary(int index) const;
  [[nodiscard]] Place place_at(float distance) const;

  /// The greatest rate of change of speed, mm/s² ≥ 0, constant from `from`
  /// (where v² is `speed_square`) to `to`, `distance` mm further in the
  /// direction of `travel`, for which no axis exceeds its acceleration at
  /// either end nor would if it stood still there.
  [[nodiscard]] float steepest(const Place& from,
                               const Place& to,
                               float distance,
                               float speed_square,
                               Travel travel,
                               Change change) const;

 private:
  [[nodiscard]] float angle_of(int index) const;
  [[nodiscard]] Place place_with(float cosine, float sine) const;

  int count_ = 1;
  int first_grid_ = 0;        ///< Grid index of boundary 1.
  float start_angle_ = 0.0F;  ///< Of the tangent, mirrored so that it grows.
  float sweep_ = 0.0F;
  float side_ = 1.0F;  ///< +1 counter-clockwise.
  float length_ = 0.0F;
  float mm_per_radian_ = 0.0F;
  float plane_share_ = 0.0F;
  float curvature_ = 0.0F;
  float straight_acceleration_ = 0.0F;  ///< Limit set by the axes whose direction is constant.
  float straight_speed_square_ = 0.0F;
  float acceleration_first_ = 0.0F;
  float acceleration_second_ = 0.0F;
  float rate_first_ = 0.0F;
  float rate_second_ = 0.0F;
};

}  // namespace cnc::motion
