#include "planner/motion/lookahead/spans.hpp"

#include <algorithm>
#include <cmath>

#include "planner/base/scalar_math.hpp"

namespace cnc::motion {
namespace {

constexpr float kGridAngle = kTwoPi / static_cast<float>(Spans::kGridPerTurn);

/// Boundaries nearer than this to an end of the arc are left out: a reversal
/// this near to an end moves an axis by R · 5e-11, far below a step.
constexpr float kSliver = 1.0e-5F;

/// Limits are met at places at most a grid step, or the reach of the window, apart.
/// Between them an axis acceleration f can rise by at most (angle)² / 8 · |f″| with
/// |f″| ≤ 5 times the limit (differentiate t·a + t′·v² twice, with v² linear in the
/// angle): 0.27 % for 3.75°. A thousandth at least is left for rounding, and for who measures it
/// by steps.
float margin_for(float angle) {
  constexpr float kRounding = 2.0e-4F;
  constexpr float kLeast = 1.0e-3F;
  return 1.0F - std::max(kLeast, kRounding + 0.625F * square(angle));
}

/// With a window of so many radians either way an arc's limits are those of many directions, …
constexpr float kFarReach = kTwoPi / 48.0F;
/// … in spans of at most so many.
constexpr float kUniformSpan = kTwoPi / 96.0F;

/// Of the v² at which there all acceleration is for turning: a third of it is left to slow
/// down by when an override is lowered or the feed held.
constexpr float kTurningShare = 0.95F;

}  // namespace

Spans::Spans(const Block& block, const Limits& limits, const TimeWindow& window, Grid grid)
    : length_{block.length},
      straight_acceleration_{block.acceleration},
      straight_speed_square_{block.speed_limit_square},
      window_{window} {
  if (window.filters()) {
    head_ = block.head;
    tail_ = block.tail;
    float sum = 0.0F;
    for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
      const float share = std::abs(block.direction[axis]);
      const float limit = planned_acceleration(limits, axis, window);
      sum += square(limit);
      if (limit < straight_acceleration_ * share) straight_acceleration_ = limit / share;
    }
    all_axes_ = std::sqrt(sum);
  }
  if (block.turns()) lay_out_arc(block, limits, grid);
  own_count_ = count_;
  if (window.filters()) lay_out_edges();
}

void Spans::lay_out_edges() {
  for (const LimitZone& zone : head_) add_edge(zone.length);
  for (const LimitZone& zone : tail_) {
    if (zone.length > 0.0F) add_edge(length_ - zone.length);
  }
  int own = 1;
  int kept = 0;
  for (int k = 0; k < edge_count_; ++k) {
    const float edge = edges_[static_cast<std::size_t>(k)];
    while (own < own_count_ && own_boundary(own) < edge) ++own;
    if (own < own_count_ && own_boundary(own) <= edge) continue;
    edges_[static_cast<std::size_t>(kept)] = edge;
    edge_indices_[static_cast<std::size_t>(kept)] = own + kept;
    ++kept;
  }
  edge_count_ = kept;
  count_ = own_count_ + edge_count_;
}

/// Keeps the edges in order. A zone's edge is exact, however near to another it
/// is: a zone of some nanometres must not become one of a metre.
void Spans::add_edge(float distance) {
  if (distance <= 0.0F || distance >= length_) return;
  const auto count = static_cast<std::size_t>(edge_count_);
  std::size_t place = count;
  while (place > 0 && edges_[place - 1] >= distance) --place;
  if (place < count && edges_[place] <= distance) return;
  for (std::size_t k = count; k > place; --k) edges_[k] = edges_[k - 1];
  edges_[place] = distance;
  ++edge_count_;
}

/// Notes the axes of its plane. Returns the acceleration that all of them allow in any direction.
float Spans::take_axes(const Block& block, const Limits& limits) {
  float least = 1.0e12F;
  for (const AxisInPlane& each : AxesInPlane{block.turn.plane, side_}) {
    const float acceleration = planned_acceleration(limits, each.axis, window_);
    arc_axes_[arc_axis_count_++] = {each, acceleration, motor_rate(limits, each.axis)};
    least = std::min(least, acceleration / each.size);
  }
  return least;
}

void Spans::lay_out_arc(const Block& block, const Limits& limits, Grid grid) {
  const TimeWindow& window = window_;
  const Turn& turn = block.turn;
  plane_share_ = turn.plane_share;
  side_ = turn.half_sweep < 0.0F ? -1.0F : 1.0F;
  start_angle_ = side_ * turn.start_angle;
  sweep_ = 2.0F * std::abs(turn.half_sweep);
  mm_per_radian_ = length_ / sweep_;
  curvature_ = turn.curvature;
  const float least = take_axes(block, limits);
  plane_acceleration_ = least * margin_for(kGridAngle);
  most_acceleration_ = plane_acceleration_;
  turning_ = Turning::of(curvature_, plane_acceleration_);
  straight_speed_square_ = std::min(
      straight_speed_square_, turning_.speed_limit_square(window.seconds()) / square(plane_share_));
  const float farthest = std::min(window.reach(straight_speed_square_) / mm_per_radian_, sweep_);
  if (farthest > kFarReach) {
    const float centripetal = 1.0F / (turning_.speed_ratio * square(plane_share_));
    straight_speed_square_ = std::min(straight_speed_square_, kTurningShare * centripetal);
  }
  const float around = reach_within(straight_speed_square_, block.reachable_square);
  reach_ = std::min(farthest, around / mm_per_radian_);
  uniform_ = reach_ > kFarReach;
  if (window.filters()) lay_out_turning(least, block.reachable_square);
  if (grid == Grid::kFine && !window.filters()) split_ = finest_split();
  grid_angle_ = kGridAngle / static_cast<float>(split_);
  const float margin = margin_for(std::max(grid_angle_, uniform_ ? 0.0F : reach_));
  float sum = 0.0F;
  for (ArcAxis& axis : arc_axes_) {
    axis.acceleration *= margin;
    sum += square(axis.acceleration);
  }
  if (uniform_) {
    most_acceleration_ = std::sqrt(sum);
    count_ = std::max(1, static_cast<int>(std::ceil(sweep_ / kUniformSpan)));
  } else {
    lay_out_grid();
  }
}

/// Where an arc has few directions there is more than the lesser of its axes' limits. What is
/// needed for turning is held against all of its normals, and what that leaves of each axis
/// against all of its tangents: an ellipse of both fits in where
///   (T_i a)² + (N_i b)² ≤ A_i²
/// for the greatest shares T and N that either has of axis i.
void Spans::lay_out_turning(float least, float reachable_square) {
  constexpr float kLeastShare = 1.0e-6F;
  constexpr float kWorthIt = 1.01F;
  /// Of what is needed on the way; nearer to it there is little left for speeding up.
  constexpr float kRoom = 2.0F;
  const DirectionRange directions{start_angle_, start_angle_ + sweep_};
  const float margin = plane_acceleration_ / least;
  const auto left_beside = [&](float normal) {
    float left = 1.0e12F;
    for (const ArcAxis& axis : arc_axes()) {
      const float most = margin * axis.acceleration;
      const AxisShares shares = directions.greatest_shares(axis.in_plane);
      const float used = shares.normal * normal;
      const float share = std::max(shares.tangent, kLeastShare);
      left = std::min(left, std::sqrt(std::max(0.0F, square(most) - square(used))) / share);
    }
    return left;
  };
  most_acceleration_ = left_beside(0.0F);
  if (most_acceleration_ < plane_acceleration_ * kWorthIt) return;
  const float window_s = window_.seconds();
  const float met =
      plane_share_ * std::sqrt(reachable_square) + 0.5F * most_acceleration_ * window_s;
  const float speed = std::min(plane_share_ * std::sqrt(straight_speed_square_), met);
  const float needed = curvature_ * speed * std::max(speed, 3.0F * window_s * most_acceleration_);
  const float normal = std::min(plane_acceleration_, kRoom * needed);
  const float along = left_beside(normal);
  if (along < plane_acceleration_ * kWorthIt) return;
  plane_acceleration_ = along;
  turning_ = {curvature_ * (along / normal), curvature_ / normal, square(curvature_) / along};
}

/// In how many a span of the usual grid is divided.
int Spans::finest_split() const {
  constexpr float kMostSplit = 16.0F;
  constexpr float kShortestSpan = 0.7e-3F;  // s.
  // However fast it may be driven: one axis alone may turn the motion.
  float greatest = 0.0F;
  for (const ArcAxis& axis : arc_axes()) greatest = std::max(greatest, axis.acceleration);
  const float turned = greatest / (curvature_ * square(plane_share_));
  const float seconds = length_ / std::sqrt(std::min(straight_speed_square_, turned));
  const float most = std::min(seconds / kShortestSpan, static_cast<float>(kMostFineSpans - 2));
  constexpr float kRounding = 1.0e-3F;
  const float split = most / std::max(1.0F, sweep_ / kGridAngle) + kRounding;
  return static_cast<int>(std::clamp(split, 1.0F, kMostSplit));
}

void Spans::lay_out_grid() {
  first_grid_ = static_cast<int>(std::floor((start_angle_ + kSliver) / grid_angle_)) + 1;
  const int last_grid =
      static_cast<int>(std::ceil((start_angle_ + sweep_ - kSliver) / grid_angle_)) - 1;
  const int most = split_ > 1 ? kMostFineSpans : kMostSpans - kMostEdges;
  count_ = std::clamp(last_grid - first_grid_ + 2, 1, most);
}

}  // namespace cnc::motion
