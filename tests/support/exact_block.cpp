#include "tests/support/exact_block.hpp"

#include <cmath>

namespace proof {

double norm(const Vector& vector) {
  double sum = 0.0;
  for (const double x : vector) sum += x * x;
  return std::sqrt(sum);
}

Vector to_mm(const cnc::Position& position) {
  Vector place{};
  for (std::size_t axis = 0; axis < cnc::kAxisCount; ++axis) {
    place[axis] = static_cast<double>(position[axis].nanometres()) * 1.0e-6;
  }
  return place;
}

ExactBlock::ExactBlock(const cnc::PathElement& element)
    : start_{to_mm(element.start)}, plane_{element.plane}, axes_{cnc::axes_of(element.plane)} {
  for (std::size_t axis = 0; axis < cnc::kAxisCount; ++axis) {
    const cnc::Coordinate travel = element.end[axis] - element.start[axis];
    travel_[axis] = static_cast<double>(travel.nanometres()) * 1.0e-6;
  }
  chord_ = std::hypot(travel_[axes_.first], travel_[axes_.second]);
  if (element.bulge != 0.0F && chord_ > 0.0) {
    half_sweep_ = 2.0 * std::atan(static_cast<double>(element.bulge));
    chord_angle_ = std::atan2(travel_[axes_.second], travel_[axes_.first]);
  }
  plane_length_ = turns() ? chord_ * half_sweep_ / std::sin(half_sweep_) : chord_;
  Vector straight = travel_;
  straight[axes_.first] = 0.0;
  straight[axes_.second] = 0.0;
  length_ = std::hypot(norm(straight), plane_length_);
}

double ExactBlock::radius() const {
  return turns() ? chord_ / (2.0 * std::sin(std::abs(half_sweep_))) : 0.0;
}

Vector ExactBlock::place_at(double fraction) const {
  Vector place = start_;
  for (std::size_t axis = 0; axis < place.size(); ++axis) place[axis] += travel_[axis] * fraction;
  if (!turns()) return place;
  // The chord of the first part of the arc: half its sweep behind its end tangent.
  const double part = chord_ * std::sin(half_sweep_ * fraction) / std::sin(half_sweep_);
  const double angle = chord_angle_ + half_sweep_ * (fraction - 1.0);
  place[axes_.first] = start_[axes_.first] + part * std::cos(angle);
  place[axes_.second] = start_[axes_.second] + part * std::sin(angle);
  return place;
}

Vector ExactBlock::tangent_at(double fraction) const {
  Vector tangent = travel_;
  for (double& share : tangent) share /= length_;
  if (!turns()) return tangent;
  const double angle = chord_angle_ + half_sweep_ * (2.0 * fraction - 1.0);
  tangent[axes_.first] = plane_share() * std::cos(angle);
  tangent[axes_.second] = plane_share() * std::sin(angle);
  return tangent;
}

Vector ExactBlock::bend_at(double fraction) const {
  Vector bend{};
  if (!turns()) return bend;
  const double angle = chord_angle_ + half_sweep_ * (2.0 * fraction - 1.0);
  const double size = plane_share() * 2.0 * half_sweep_ / length_;
  bend[axes_.first] = -size * std::sin(angle);
  bend[axes_.second] = size * std::cos(angle);
  return bend;
}

double ExactBlock::feed_length() const {
  double linear = 0.0;
  for (std::size_t axis = 0; axis < cnc::kLinearAxisCount; ++axis) {
    const bool round = turns() && (axis == axes_.first || axis == axes_.second);
    if (!round) linear += travel_[axis] * travel_[axis];
  }
  if (turns()) linear += plane_length_ * plane_length_;
  return linear > 0.0 ? std::sqrt(linear) : length_;
}

}  // namespace proof
