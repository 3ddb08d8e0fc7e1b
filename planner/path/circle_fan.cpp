#include "planner/path/circle_fan.hpp"

#include <algorithm>
#include <cmath>

namespace cnc::path {
namespace {

FanCircle between(const FanCircle& a, const FanCircle& b, float share) {
  return {.curvature = a.curvature + share * (b.curvature - a.curvature),
          .slope = a.slope + share * (b.slope - a.slope)};
}

}  // namespace

void CircleFan::open(float max_curvature) {
  corners_[0] = {-max_curvature, -kSteepest};
  corners_[1] = {max_curvature, -kSteepest};
  corners_[2] = {max_curvature, kSteepest};
  corners_[3] = {-max_curvature, kSteepest};
  count_ = 4;
}

/// Keeps the circles of curvature k and slope t with |weight · k + 2 x t − 2 y| ≤ 2 Q, where (x, y)
/// is `point` and Q is `within_mm`.
void CircleFan::pass(const Vec2& point, float weight, float within_mm) {
  const float along = 2.0F * point.x();
  const float beside = 2.0F * point.y();
  keep(weight, along, 2.0F * within_mm + beside);
  keep(-weight, -along, 2.0F * within_mm - beside);
}

/// Keeps the circles of curvature k and slope t with by_curvature · k + by_slope · t ≤ most.
void CircleFan::keep(float by_curvature, float by_slope, float most) {
  std::size_t beyond = 0;
  for (std::size_t i = 0; i < count_; ++i) {
    excess_[i] = by_curvature * corners_[i].curvature + by_slope * corners_[i].slope - most;
    if (excess_[i] > 0.0F) ++beyond;
  }
  if (beyond == 0) return;
  if (beyond == count_) {
    count_ = 0;
    return;
  }
  // The corners outside the half plane are consecutive, because the polygon is convex.
  std::size_t first = 0;
  if (excess_[0] > 0.0F) {
    first = count_;
    while (excess_[first - 1] > 0.0F) --first;
    if (first == count_) first = 0;
  } else {
    while (excess_[first] <= 0.0F) ++first;
  }
  std::size_t past = first;
  do {
    past = past + 1 < count_ ? past + 1 : 0;
  } while (excess_[past] > 0.0F);
  cut(first, past);
}

/// Replaces the corners from `first` up to the corner before `past`, which are all outside the half
/// plane. Their replacement is the two points where the sides of the polygon leave the half plane
/// (Sutherland, Hodgman).
void CircleFan::cut(std::size_t first, std::size_t past) {
  const auto leaves = [this](std::size_t inside, std::size_t beyond) {
    const float share = excess_[inside] / (excess_[inside] - excess_[beyond]);
    return between(corners_[inside], corners_[beyond], share);
  };
  const FanCircle out = leaves(first > 0 ? first - 1 : count_ - 1, first);
  const FanCircle in = leaves(past, past > 0 ? past - 1 : count_ - 1);
  FanCircle* const corners = corners_.data();
  std::size_t at = first;
  if (past > first) {
    const std::size_t rest = count_ - past;
    if (past > first + 1) {
      std::copy(corners + past, corners + count_, corners + first + 2);
    } else {
      std::copy_backward(corners + past, corners + count_, corners + count_ + 1);
    }
    count_ = first + 2 + rest;
  } else {
    at = first - past;
    if (past > 0) std::copy(corners + past, corners + first, corners);
    count_ = at + 2;
  }
  corners_[at] = out;
  corners_[at + 1] = in;
  if (count_ > kMaxCorners) drop_smallest();
}

/// Removes the corner whose triangle with its neighbours is the smallest. The polygon becomes a
/// little smaller and stays convex.
void CircleFan::drop_smallest() {
  std::size_t smallest = 0;
  float least = 1.0e30F;
  for (std::size_t i = 0; i < count_; ++i) {
    const FanCircle& a = corners_[(i + count_ - 1) % count_];
    const FanCircle& b = corners_[i];
    const FanCircle& c = corners_[(i + 1) % count_];
    const float area = std::abs((b.curvature - a.curvature) * (c.slope - a.slope) -
                                (c.curvature - a.curvature) * (b.slope - a.slope));
    if (area < least) {
      least = area;
      smallest = i;
    }
  }
  for (std::size_t i = smallest; i + 1 < count_; ++i) corners_[i] = corners_[i + 1];
  --count_;
}

std::optional<CircleFan::Through> CircleFan::through(const Vec2& point, float weight) const {
  if (empty()) return std::nullopt;
  const auto excess = [&](const FanCircle& circle) {
    return weight * circle.curvature + 2.0F * (point.x() * circle.slope - point.y());
  };
  std::array<FanCircle, 2> found{};
  std::size_t found_count = 0;
  FanCircle last = corners_[count_ - 1];
  float last_excess = excess(last);
  for (std::size_t i = 0; i < count_; ++i) {
    const float here = excess(corners_[i]);
    const bool crosses = (here > 0.0F) != (last_excess > 0.0F);
    if (crosses && found_count < found.size()) {
      found[found_count++] = between(last, corners_[i], last_excess / (last_excess - here));
    }
    last = corners_[i];
    last_excess = here;
  }
  if (found_count < 2) return std::nullopt;
  const bool in_order = found[0].slope <= found[1].slope;
  return Through{in_order ? found[0] : found[1], in_order ? found[1] : found[0]};
}

}  // namespace cnc::path
