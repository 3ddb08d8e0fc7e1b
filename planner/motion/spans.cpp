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

/// Limits are met at both ends of a span. Between them an axis acceleration f
/// can rise by at most (span angle)² / 8 · |f″| with |f″| ≤ 5 times the limit
/// (differentiate t·a + t′·v² twice, with v² linear in the angle): 0.27 %.
constexpr float kArcMargin = 1.0F - 0.0029F;

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

}  // namespace

Spans::Spans(const Block& block, const Limits& limits)
    : length_{block.length}, straight_speed_square_{block.speed_limit_square} {
  straight_acceleration_ = 1.0e9F;
  for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
    const float share = std::abs(block.direction[axis]);
    if (limits.acceleration_mm_s2[axis] < straight_acceleration_ * share) {
      straight_acceleration_ = limits.acceleration_mm_s2[axis] / share;
    }
  }
  if (!block.turns()) return;

  const Turn& turn = block.turn;
  const PlaneAxes axes = axes_of(turn.plane);
  plane_share_ = turn.plane_share;
  curvature_ = turn.curvature;
  acceleration_first_ = limits.acceleration_mm_s2[axes.first] * kArcMargin;
  acceleration_second_ = limits.acceleration_mm_s2[axes.second] * kArcMargin;
  rate_first_ = motor_rate(limits, axes.first);
  rate_second_ = motor_rate(limits, axes.second);
  straight_speed_square_ = std::min(
      straight_speed_square_,
      std::min(acceleration_first_, acceleration_second_) / (curvature_ * square(plane_share_)));
  side_ = turn.half_sweep < 0.0F ? -1.0F : 1.0F;
  start_angle_ = side_ * turn.start_angle;
  sweep_ = 2.0F * std::abs(turn.half_sweep);
  mm_per_radian_ = length_ / sweep_;
  first_grid_ = static_cast<int>(std::floor((start_angle_ + kSliver) / kGridAngle)) + 1;
  const int last_grid =
      static_cast<int>(std::ceil((start_angle_ + sweep_ - kSliver) / kGridAngle)) - 1;
  count_ = std::clamp(last_grid - first_grid_ + 2, 1, kMostSpans);
}

float Spans::angle_of(int index) const {
  if (index <= 0) return start_angle_;
  if (index >= count_) return start_angle_ + sweep_;
  return static_cast<float>(first_grid_ + index - 1) * kGridAngle;
}

float Spans::boundary(int index) const {
  if (index <= 0) return 0.0F;
  if (index >= count_) return length_;
  return (angle_of(index) - start_angle_) * mm_per_radian_;
}

bool Spans::near_reversal(int span) const {
  if (sweep_ <= 0.0F) return false;
  const float middle = 0.5F * (angle_of(span) + angle_of(span + 1));
  const auto cell = static_cast<int>(std::floor(middle / kGridAngle));
  const int in_quarter = ((cell % kGridPerQuarter) + kGridPerQuarter) % kGridPerQuarter;
  return in_quarter == 0 || in_quarter == kGridPerQuarter - 1;
}

Place Spans::place_with(float cosine, float sine) const {
  const float bend = square(plane_share_) * curvature_;
  return {.tangent_first = plane_share_ * cosine,
          .tangent_second = side_ * plane_share_ * sine,
          .bend_first = -bend * sine,
          .bend_second = side_ * bend * cosine};
}

Place Spans::place_at_boundary(int index) const {
  if (sweep_ <= 0.0F) return {};
  const SinCos turned = index <= 0 || index >= count_ ? sin_cos(angle_of(index))
                                                      : grid_sin_cos(first_grid_ + index - 1);
  return place_with(turned.cosine, turned.sine);
}

Place Spans::place_at(float distance) const {
  if (sweep_ <= 0.0F) return {};
  const SinCos turned = sin_cos(start_angle_ + distance / mm_per_radian_);
  return place_with(turned.cosine, turned.sine);
}

float Spans::speed_limit_square(int span) const {
  if (sweep_ <= 0.0F) return straight_speed_square_;
  const Place from = place_at_boundary(span);
  const Place to = place_at_boundary(span + 1);
  const float share_first = std::max(std::abs(from.tangent_first), std::abs(to.tangent_first));
  const float share_second = std::max(std::abs(from.tangent_second), std::abs(to.tangent_second));
  float limit = straight_speed_square_;
  if (square(rate_first_) < limit * square(share_first)) limit = square(rate_first_ / share_first);
  if (square(rate_second_) < limit * square(share_second)) {
    limit = square(rate_second_ / share_second);
  }
  return limit;
}

float Spans::steepest(const Place& from,
                      const Place& to,
                      float distance,
                      float speed_square,
                      Travel travel,
                      Change change) const {
  float most = straight_acceleration_;
  if (sweep_ <= 0.0F) return most;
  const float sign = static_cast<float>(change);
  const float reach = 2.0F * distance * static_cast<float>(travel);
  const auto meet = [&](float limit, float tangent, float bend, float tangent_to, float bend_to) {
    most = tighten(most, limit, std::max(std::abs(tangent), std::abs(tangent_to)), 0.0F);
    most = tighten(most, limit, sign * tangent, bend * speed_square);
    most = tighten(most, limit, sign * (tangent_to + reach * bend_to), bend_to * speed_square);
  };
  meet(acceleration_first_, from.tangent_first, from.bend_first, to.tangent_first, to.bend_first);
  meet(acceleration_second_,
       from.tangent_second,
       from.bend_second,
       to.tangent_second,
       to.bend_second);
  return most;
}

}  // namespace cnc::motion
