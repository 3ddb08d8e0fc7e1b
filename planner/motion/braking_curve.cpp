#include "planner/motion/braking_curve.hpp"

namespace cnc::motion {

void BrakingCurve::begin(bool filters) {
  if (filters == std::holds_alternative<Filtered>(points_)) return;
  if (filters) {
    points_.emplace<Filtered>();
  } else {
    points_.emplace<Plain>();
  }
}

void BrakingCurve::keep(int span, const BrakingPoint& point) {
  const auto index = static_cast<std::size_t>(span);
  if (Plain* const plain = std::get_if<Plain>(&points_)) {
    (*plain)[index] = {point.end.speed_square, point.deceleration, point.cap_square};
  } else {
    (*std::get_if<Filtered>(&points_))[index] = point;
  }
}

BrakingPoint BrakingCurve::at(int span) const {
  const auto index = static_cast<std::size_t>(span);
  if (const Filtered* const filtered = std::get_if<Filtered>(&points_)) return (*filtered)[index];
  const PlainBraking& point = (*std::get_if<Plain>(&points_))[index];
  return {.end = {.speed_square = point.end_square},
          .deceleration = point.deceleration,
          .cap_square = point.cap_square};
}

bool BrakingCurve::stays_level(int span, float speed_square) const {
  const PlainBraking& point = (*std::get_if<Plain>(&points_))[static_cast<std::size_t>(span)];
  return point.cap_square >= speed_square &&
         point.cap_square <= speed_square * (1.0F + kNegligibleShare) &&
         point.end_square >= speed_square;
}

}  // namespace cnc::motion
