#include "planner/motion/spans.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "planner/base/scalar_math.hpp"

namespace cnc::motion {
namespace {

constexpr int kGridPerQuarter = Spans::kGridPerTurn / 4;
constexpr float kGridAngle = kTwoPi / static_cast<float>(Spans::kGridPerTurn);

/// Boundaries nearer than this to an end of the arc are left out: a reversal
/// this near to an end moves an axis by R · 5e-11, far below a step.
constexpr float kSliver = 1.0e-5F;

/// Limits are met at places at most a grid step, or the reach of the window, apart.
/// Between them an axis acceleration f can rise by at most (angle)² / 8 · |f″| with
/// |f″| ≤ 5 times the limit (differentiate t·a + t′·v² twice, with v² linear in the
/// angle): 0.27 % for 3.75°.
float margin_for(float angle) {
  constexpr float kRounding = 2.0e-4F;
  return 1.0F - kRounding - 0.625F * square(angle);
}

/// With a window of so many radians either way an arc is taken as uniform, …
constexpr float kFarReach = kTwoPi / 48.0F;
/// … in spans of at most so many.
constexpr float kUniformSpan = kTwoPi / 12.0F;

/// sin(k · 3.75°) for a quarter turn, by Taylor's series at compile time.
constexpr std::array<float, kGridPerQuarter + 1> make_quarter_sines() {
  std::array<float, kGridPerQuarter + 1> sines{};
  for (int k = 0; k <= kGridPerQuarter; ++k) {
    const long double x = 1.57079632679489661923L * k / kGridPerQuarter;
    long double term = x;
    long double sum = x;
    for (int n = 1; n < 12; ++n) {
      term *= -x * x / static_cast<long double>((2 * n) * (2 * n + 1));
      sum += term;
    }
    sines[static_cast<std::size_t>(k)] = static_cast<float>(sum);
  }
  return sines;
}
constexpr auto kQuarterSines = make_quarter_sines();

SinCos grid_sin_cos(int index) {
  const int wrapped = ((index % Spans::kGridPerTurn) + Spans::kGridPerTurn) % Spans::kGridPerTurn;
  const auto within = static_cast<std::size_t>(wrapped % kGridPerQuarter);
  return turned_by_quarters({kQuarterSines[within], kQuarterSines[kGridPerQuarter - within]},
                            wrapped / kGridPerQuarter);
}

/// Greatest x ≥ 0 with |gradient · x + offset| ≤ limit, or `most` if smaller.
/// No x mends an offset that rounding put beyond the limit where gradient = 0.
float tighten(float most, float limit, float gradient, float offset) {
  const float room = limit - (gradient > 0.0F ? offset : -offset);
  const float steepness = std::abs(gradient);
  if (room >= most * steepness || steepness <= 0.0F) return most;
  return std::max(0.0F, room) / steepness;
}

/// mm to either side of a place from which its limits hold for the plan, where
/// v² is at most `cap_square` and the acceleration at most `acceleration`.
float window_reach(const TimeWindow& window, float cap_square, float acceleration) {
  if (!window.filters()) return 0.0F;
  // Half the window at that speed, what speeding up from rest adds to it (A T² / 12),
  // and the cell in which the motion is taken as of one acceleration.
  const float seconds = window.seconds();
  return std::sqrt(cap_square) * (0.5F * seconds + window.cell_seconds()) +
         acceleration * square(seconds) / 12.0F;
}

}  // namespace

Spans::Spans(const Block& block, const Limits& limits, const TimeWindow& window)
    : length_{block.length},
      straight_acceleration_{block.acceleration},
      straight_speed_square_{block.speed_limit_square},
      window_{window} {
  if (window.filters()) {
    head_ = block.head;
    tail_ = block.tail;
    for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
      const float share = std::abs(block.direction[axis]);
      const float limit = planned_acceleration(limits, axis, window);
      if (limit < straight_acceleration_ * share) straight_acceleration_ = limit / share;
    }
  }
  if (block.turns()) {
    lay_out_arc(block, limits, window);
  } else if (window.filters()) {
    lay_out_straight();
  }
}

void Spans::lay_out_straight() {
  for (const LimitZone& zone : head_) add_edge(zone.length);
  for (const LimitZone& zone : tail_) {
    if (zone.length > 0.0F) add_edge(length_ - zone.length);
  }
}

/// Keeps the edges in order. A zone's edge is exact, however near to another it
/// is: a zone of some nanometres must not become one of a metre.
void Spans::add_edge(float distance) {
  if (distance <= 0.0F || distance >= length_) return;
  auto place = static_cast<std::size_t>(count_ - 1);
  while (place > 0 && edges_[place - 1] >= distance) --place;
  const auto last = static_cast<std::size_t>(count_ - 1);
  if (place < last && edges_[place] <= distance) return;
  for (std::size_t k = last; k > place; --k) edges_[k] = edges_[k - 1];
  edges_[place] = distance;
  ++count_;
}

void Spans::lay_out_arc(const Block& block, const Limits& limits, const TimeWindow& window) {
  const Turn& turn = block.turn;
  const PlaneAxes axes = axes_of(turn.plane);
  plane_share_ = turn.plane_share;
  side_ = turn.half_sweep < 0.0F ? -1.0F : 1.0F;
  start_angle_ = side_ * turn.start_angle;
  sweep_ = 2.0F * std::abs(turn.half_sweep);
  mm_per_radian_ = length_ / sweep_;
  rate_first_ = motor_rate(limits, axes.first);
  rate_second_ = motor_rate(limits, axes.second);
  acceleration_first_ = planned_acceleration(limits, axes.first, window);
  acceleration_second_ = planned_acceleration(limits, axes.second, window);

  const float least = std::min(acceleration_first_, acceleration_second_);
  plane_acceleration_ = least * margin_for(kGridAngle);
  turning_ = Turning::of(turn.curvature, plane_acceleration_);
  straight_speed_square_ = std::min(
      straight_speed_square_, turning_.speed_limit_square(window.seconds()) / square(plane_share_));
  reach_ = window_reach(window, straight_speed_square_, least) / mm_per_radian_;
  uniform_ = reach_ > kFarReach;
  const float margin = margin_for(std::max(kGridAngle, uniform_ ? 0.0F : reach_));
  acceleration_first_ *= margin;
  acceleration_second_ *= margin;
  if (uniform_) {
    count_ = std::max(1, static_cast<int>(std::ceil(sweep_ / kUniformSpan)));
  } else {
    lay_out_grid();
  }
}

void Spans::lay_out_grid() {
  first_grid_ = static_cast<int>(std::floor((start_angle_ + kSliver) / kGridAngle)) + 1;
  const int last_grid =
      static_cast<int>(std::ceil((start_angle_ + sweep_ - kSliver) / kGridAngle)) - 1;
  count_ = std::clamp(last_grid - first_grid_ + 2, 1, kMostSpans);
}

float Spans::angle_of(int index) const {
  if (index <= 0) return start_angle_;
  if (index >= count_) return start_angle_ + sweep_;
  if (uniform_) {
    return start_angle_ + sweep_ * (static_cast<float>(index) / static_cast<float>(count_));
  }
  return static_cast<float>(first_grid_ + index - 1) * kGridAngle;
}

float Spans::boundary(int index) const {
  if (index <= 0) return 0.0F;
  if (index >= count_) return length_;
  if (sweep_ <= 0.0F) return edges_[static_cast<std::size_t>(index - 1)];
  return (angle_of(index) - start_angle_) * mm_per_radian_;
}

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

LimitZone Spans::zone(float cap_square) const {
  LimitZone zone{.speed_square = cap_square, .acceleration = straight_acceleration_};
  if (sweep_ > 0.0F) {
    zone.acceleration = std::min(zone.acceleration, plane_acceleration_);
    const float share = plane_share_;
    zone.turning = {turning_.curvature * share,
                    turning_.speed_ratio * square(share),
                    turning_.jerk_ratio * square(share) * share};
  }
  zone.length = window_reach(window_, cap_square, zone.acceleration);
  return zone;
}

Place Spans::place_with(float cosine, float sine) const {
  const float bend = square(plane_share_) * turning_.curvature;
  return {.tangent_first = plane_share_ * cosine,
          .tangent_second = side_ * plane_share_ * sine,
          .bend_first = -bend * sine,
          .bend_second = side_ * bend * cosine};
}

Place Spans::place_of(float angle) const {
  const SinCos turned = sin_cos(angle);
  return place_with(turned.cosine, turned.sine);
}

Place Spans::place_at_boundary(int index) const {
  if (sweep_ <= 0.0F) return {};
  if (uniform_ || index <= 0 || index >= count_) return place_of(angle_of(index));
  const SinCos turned = grid_sin_cos(first_grid_ + index - 1);
  return place_with(turned.cosine, turned.sine);
}

Place Spans::place_at(float distance) const {
  if (sweep_ <= 0.0F) return {};
  return place_of(start_angle_ + distance / mm_per_radian_);
}

/// Of what the window spans around a span: the greatest shares of the speed that
/// fall to the axes of the plane.
Shares Spans::greatest_shares(int span) const {
  if (uniform_) return {plane_share_, plane_share_};
  const Place from = reach_ > 0.0F ? place_of(angle_of(span) - reach_) : place_at_boundary(span);
  const Place to =
      reach_ > 0.0F ? place_of(angle_of(span + 1) + reach_) : place_at_boundary(span + 1);
  Shares shares{std::max(std::abs(from.tangent_first), std::abs(to.tangent_first)),
                std::max(std::abs(from.tangent_second), std::abs(to.tangent_second))};
  // An axis that the tangent lies along in between has all of it.
  const float middle = 0.5F * (angle_of(span) + angle_of(span + 1)) / kHalfPi;
  const float nearest = std::floor(middle + 0.5F);
  const float half = 0.5F * (angle_of(span + 1) - angle_of(span)) + reach_;
  if (std::abs(middle - nearest) * kHalfPi > half) return shares;
  const bool along_second = (static_cast<int>(nearest) & 1) != 0;
  (along_second ? shares.second : shares.first) = plane_share_;
  return shares;
}

float Spans::speed_limit_square(int span) const {
  if (sweep_ <= 0.0F) return straight_speed_square_;
  const Shares shares = greatest_shares(span);
  float limit = straight_speed_square_;
  const auto keep = [&limit](float rate, float share) {
    if (square(rate) < limit * square(share)) limit = square(rate / share);
  };
  keep(rate_first_, shares.first);
  keep(rate_second_, shares.second);
  return limit;
}

float Spans::steepest(int span,
                      const Place& from,
                      const Place& to,
                      const SpeedChange& change) const {
  const auto& [distance, speed_square, cap_square, travel, wanted, growing] = change;
  const LimitZone zone = zone_on(span);
  float most = std::min(straight_acceleration_, zone.acceleration);
  const float window_s = window_.seconds();
  most = zone.turning.steepest(most, growing, speed_square, cap_square, window_s);
  if (sweep_ <= 0.0F) return most;
  if (window_.filters()) most = within_turning(most, change);
  if (uniform_) return most;

  const float sign = static_cast<float>(wanted);
  const float reach = 2.0F * distance * static_cast<float>(travel);
  const float square_there = speed_square;
  const auto meet = [&](const Place& place, bool at_from, bool at_to) {
    const auto meet_axis = [&](float limit, float tangent, float bend) {
      most = tighten(most, limit, std::abs(tangent), 0.0F);
      if (at_from) most = tighten(most, limit, sign * tangent, bend * square_there);
      if (at_to) most = tighten(most, limit, sign * (tangent + reach * bend), bend * square_there);
    };
    meet_axis(acceleration_first_, place.tangent_first, place.bend_first);
    meet_axis(acceleration_second_, place.tangent_second, place.bend_second);
  };
  const bool around = reach_ > 0.0F;
  meet(from, true, around);
  meet(to, around, true);
  if (!around) return most;
  meet(place_of(angle_of(span) - reach_), true, true);
  meet(place_of(angle_of(span + 1) + reach_), true, true);
  return most;
}

/// What turning leaves, of the plane's limits; as an acceleration of the path.
/// Where directions are told apart only jerk is left to it.
float Spans::within_turning(float most, const SpeedChange& change) const {
  const float to_plane = square(plane_share_);
  const float window_s = window_.seconds();
  if (uniform_) {
    const float plane = turning_.steepest(plane_acceleration_,
                                          plane_share_ * change.growing,
                                          to_plane * change.speed_square,
                                          to_plane * change.cap_square,
                                          window_s);
    return std::min(most, plane / plane_share_);
  }
  most = std::min(most, plane_acceleration_ / plane_share_);
  const float top_square =
      std::min(change.cap_square, change.speed_square + 2.0F * most * change.growing);
  const float plane = turning_.within_jerk(plane_acceleration_, to_plane * top_square, window_s);
  return std::min(most, plane / plane_share_);
}

}  // namespace cnc::motion
