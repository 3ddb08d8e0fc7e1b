#include <algorithm>
#include <cmath>

#include "planner/base/scalar_math.hpp"
#include "planner/motion/lookahead/spans.hpp"

namespace cnc::motion {
namespace {

/// Greatest x ≥ 0 with |gradient · x + offset| ≤ limit, or `most` if smaller.
/// No x mends an offset that rounding put beyond the limit where gradient = 0.
float tighten(float most, float limit, float gradient, float offset) {
  const float room = limit - (gradient > 0.0F ? offset : -offset);
  const float steepness = std::abs(gradient);
  if (room >= most * steepness || steepness <= 0.0F) return most;
  return std::max(0.0F, room) / steepness;
}

}  // namespace

/// What neighbours ask for on a span, all of it together.
LimitZone Spans::zone_on(int span) const {
  LimitZone found;
  const auto take = [&found](const LimitZone& zone) {
    found.speed_square = std::min(found.speed_square, zone.speed_square);
    found.acceleration = std::min(found.acceleration, zone.acceleration);
    found.turning = both(found.turning, zone.turning);
  };
  if (!window_.filters()) return found;
  for (const LimitZone& zone : head_) {
    if (zone.length > boundary(span)) take(zone);
  }
  for (const LimitZone& zone : tail_) {
    if (zone.length > 0.0F && length_ - zone.length < boundary(span + 1)) take(zone);
  }
  return found;
}

float Spans::greatest_acceleration() const {
  if (sweep_ <= 0.0F) return straight_acceleration_;
  return std::min(straight_acceleration_, most_acceleration_ / plane_share_);
}

LimitZone Spans::zone(float cap_square, float reachable_square) const {
  LimitZone zone{.speed_square = cap_square, .acceleration = straight_acceleration_};
  if (sweep_ > 0.0F) {
    zone.acceleration = std::min(zone.acceleration, plane_acceleration_);
    const float share = plane_share_;
    zone.turning = {turning_.curvature * share,
                    turning_.speed_ratio * square(share),
                    turning_.jerk_ratio * square(share) * share};
  }
  zone.length = reach_within(cap_square, reachable_square);
  return zone;
}

/// mm to either side of a place of this block from which its limits hold.
float Spans::reach_within(float cap_square, float reachable_square) const {
  // Beyond a block that is left with v the plan may go on speeding up: that adds A T² / 12.
  const float speeding_up = all_axes_ * square(window_.seconds()) / 12.0F;
  return std::min(window_.reach(cap_square), window_.reach(reachable_square) + speeding_up);
}

/// What the window spans before a span; the arc itself, no farther.
float Spans::angle_before(int span) const {
  return std::max(start_angle_, angle_of(span) - reach_);
}

float Spans::angle_behind(int span) const {
  return std::min(start_angle_ + sweep_, angle_of(span + 1) + reach_);
}

/// The directions that the window spans around a span between two places.
DirectionRange Spans::directions_around(int span, const Place& from, const Place& to) const {
  if (uniform_) return {};
  if (reach_ > 0.0F) return {angle_before(span), angle_behind(span)};
  return {from, to};
}

/// The greatest shares in these directions of a speed that is not in the plane alone.
AxisShares Spans::shares_of(const ArcAxis& axis, const DirectionRange& directions) const {
  const auto [tangent, normal] = directions.greatest_shares(axis.in_plane);
  return {plane_share_ * tangent, plane_share_ * normal};
}

float Spans::speed_limit_square(int span, const Place& from, const Place& to) const {
  if (sweep_ <= 0.0F) return straight_speed_square_;
  const DirectionRange directions = directions_around(span, from, to);
  float limit = straight_speed_square_;
  const auto keep = [&limit](float most, float share) {
    if (most < limit * share) limit = most / share;
  };
  const float bend = plane_share_ * curvature_;
  for (const ArcAxis& axis : arc_axes()) {
    const auto [tangent, normal] = shares_of(axis, directions);
    keep(square(axis.rate), square(tangent));
    // Under a window what turning asks for, at a level speed, is in the limit already.
    if (!window_.filters()) keep(axis.acceleration, bend * normal);
  }
  return limit;
}

float Spans::steepest(int span,
                      const Place& from,
                      const Place& to,
                      const SpeedChange& change) const {
  const auto& [distance, speed_square, cap_square, travel, wanted, growing] = change;
  float most = straight_acceleration_;
  if (window_.filters()) {
    const LimitZone zone = zone_on(span);
    most = std::min(most, zone.acceleration);
    const float window_s = window_.seconds();
    const float lag = lag_of(zone.turning.curvature, most, window_s);
    most = zone.turning.steepest(most, growing, speed_square, cap_square, window_s, lag);
  }
  if (sweep_ <= 0.0F) return most;
  if (uniform_) return within_turning(span, most, change);
  if (window_.filters()) {
    const DirectionRange directions =
        directions_around(span, place_at_boundary(span), place_at_boundary(span + 1));
    most = within_jerk(directions, most, change);
  }

  const float sign = static_cast<float>(wanted);
  const float reach = 2.0F * distance * static_cast<float>(travel);
  const float square_there = speed_square;
  const float bending = square(plane_share_) * curvature_;
  const auto meet = [&](const Place& place, bool at_from, bool at_to) {
    for (const ArcAxis& axis : arc_axes()) {
      const float tangent = plane_share_ * axis.in_plane.share(place);
      const float bend = bending * axis.in_plane.normal_share(place);
      const float limit = axis.acceleration;
      most = tighten(most, limit, std::abs(tangent), 0.0F);
      if (at_from) most = tighten(most, limit, sign * tangent, bend * square_there);
      if (at_to) most = tighten(most, limit, sign * (tangent + reach * bend), bend * square_there);
    }
  };
  const bool spans_more = reach_ > 0.0F;
  meet(from, true, spans_more);
  meet(to, spans_more, true);
  if (!spans_more) return most;
  meet(sin_cos(angle_before(span)), true, true);
  meet(sin_cos(angle_behind(span)), true, true);
  return most;
}

/// Whether vectors, given along the tangent and along the normal, are within the limits of all
/// axes wherever the tangent is within an angle.
class Spans::DirectionBox {
 public:
  /// @param first, last radians, of the tangent
  DirectionBox(float first, float last, std::span<const ArcAxis> axes)
      : middle_{sin_cos(0.5F * (first + last))},
        half_{sin_cos(std::min(0.5F * (last - first), kHalfPi))},
        axes_{axes} {}

  [[nodiscard]] bool holds(float tangent, float normal) const {
    const float length_square = square(tangent) + square(normal);
    for (const ArcAxis& axis : axes_) {
      const float along = axis.in_plane.share(middle_);
      const float across = axis.in_plane.normal_share(middle_);
      const float own = std::abs(tangent * along + normal * across);
      const float other = std::abs(tangent * across - normal * along);
      const float size_square = square(axis.in_plane.size) * length_square;
      const bool anywhere = size_square <= square(axis.acceleration);
      if (!anywhere && turned(own, other) > axis.acceleration) return false;
    }
    return true;
  }

  /// The longest vector along the tangent that it holds.
  [[nodiscard]] float most_along() const {
    float most = kFar;
    for (const ArcAxis& axis : axes_) {
      const float own = std::abs(axis.in_plane.share(middle_));
      const float other = std::abs(axis.in_plane.normal_share(middle_));
      most = std::min(most, axis.acceleration / std::min(axis.in_plane.size, turned(own, other)));
    }
    return most;
  }

 private:
  /// Of a vector with these parts along an axis and across, turned towards the axis as far as the
  /// angle goes; more than all of it where that is farther than the axis.
  [[nodiscard]] float turned(float own, float other) const {
    const bool beside = other * half_.cosine > own * half_.sine;
    return beside ? own * half_.cosine + other * half_.sine : kFar;
  }

  static constexpr float kFar = 1.0e12F;

  SinCos middle_;
  SinCos half_;
  std::span<const ArcAxis> axes_;
};

/// What turning leaves where the window spans many directions. The plan's a makes, somewhere
/// within the window, the acceleration a along the tangent and κ v² across it; and the jerk
/// a / T − κ² v³, then −a / T − κ² v³, along it and up to 3 κ v a across it. (Jerk in units of 1 /
/// T, as accelerations are limited by it, too.)
float Spans::within_turning(int span, float most, const SpeedChange& change) const {
  const float window_s = window_.seconds();
  const float cap = std::sqrt(change.cap_square);
  const float lag = lag_of(curvature_, plane_acceleration_, window_s);
  const DirectionBox box{angle_before(span), angle_behind(span), arc_axes()};
  const float sign = static_cast<float>(change.change);
  const auto fits = [&](float steep) {
    const float end = std::sqrt(change.speed_square + 2.0F * steep * change.growing);
    const float speed = plane_share_ * std::min(cap, end + steep * lag);
    const float along = plane_share_ * steep;
    const float normal = curvature_ * square(speed);
    const float inwards = curvature_ * normal * speed * window_s;
    const float across = 3.0F * curvature_ * speed * along * window_s * sign;
    return box.holds(sign * along, normal) && box.holds(along + inwards, 0.0F) &&
           box.holds(along - inwards, across) && box.holds(-along - inwards, across);
  };
  float high = std::min(most, box.most_along() / plane_share_);
  if (fits(high)) return high;
  const float to_plane = square(plane_share_);
  const float anywhere = turning_.steepest(plane_acceleration_,
                                           plane_share_ * change.growing,
                                           to_plane * change.speed_square,
                                           to_plane * change.cap_square,
                                           window_s,
                                           lag);
  float low = std::min(high, anywhere / plane_share_);
  constexpr int kBisections = 5;
  for (int i = 0; i < kBisections; ++i) {
    const float middle = 0.5F * (low + high);
    (fits(middle) ? low : high) = middle;
  }
  return low;
}

/// Where directions are told apart: an axis along which the tangent has the share t and
/// its normal the share n is asked for the jerk t (a / T + κ² v³) + n 3 κ v a at most.
float Spans::within_jerk(const DirectionRange& directions,
                         float most,
                         const SpeedChange& change) const {
  AxisArray<AxisShares> shares{};
  for (std::size_t i = 0; i < arc_axis_count_; ++i) {
    shares[i] = shares_of(arc_axes_[i], directions);
  }
  const float cap = std::sqrt(change.cap_square);
  const float lag = lag_of(curvature_, plane_acceleration_, window_.seconds());
  return steepest_within(most, [&](float steep) {
    const float end = std::sqrt(change.speed_square + 2.0F * steep * change.growing);
    return within_jerk_at(std::min(cap, end + steep * lag), most, shares);
  });
}

float Spans::within_jerk_at(float speed, float most, const AxisArray<AxisShares>& shares) const {
  const float bend = square(plane_share_) * curvature_;
  const float window_s = window_.seconds();
  // In units of A = J T, as accelerations are limited by it too.
  const float along = curvature_ * bend * speed * square(speed) * window_s;
  const float across = 3.0F * bend * speed * window_s;
  for (std::size_t i = 0; i < arc_axis_count_; ++i) {
    const auto& [tangent, normal] = shares[i];
    const float steepness = tangent + across * normal / plane_share_;
    most = tighten(most, arc_axes_[i].acceleration - tangent * along, steepness, 0.0F);
  }
  return most;
}

}  // namespace cnc::motion
