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

namespace {

double dot(const Vector& a, const Vector& b) {
  double sum = 0.0;
  for (std::size_t axis = 0; axis < a.size(); ++axis) sum += a[axis] * b[axis];
  return sum;
}

/// Returns a + `share` · b.
Vector sum_of(const Vector& a, double share, const Vector& b) {
  Vector sum = a;
  for (std::size_t axis = 0; axis < a.size(); ++axis) sum[axis] += share * b[axis];
  return sum;
}

Vector divided(const Vector& vector, double by) {
  Vector quotient = vector;
  for (double& part : quotient) part /= by;
  return quotient;
}

/// Returns the part of `vector` at right angles to the unit vector `other`, with length 1.
Vector unit_beside(const Vector& vector, const Vector& other) {
  const Vector beside = sum_of(vector, -dot(vector, other), other);
  return divided(beside, norm(beside));
}

}  // namespace

ExactBlock::ExactBlock(const cnc::PathElement& element)
    : start_{to_mm(element.start)},
      plane_{element.plane.holding(cnc::travel_between(element.start, element.end))} {
  for (std::size_t axis = 0; axis < cnc::kAxisCount; ++axis) {
    const cnc::Coordinate travel = element.end[axis] - element.start[axis];
    travel_[axis] = static_cast<double>(travel.nanometres()) * 1.0e-6;
    first_[axis] = static_cast<double>(plane_.frame().first[axis]);
    second_[axis] = static_cast<double>(plane_.frame().second[axis]);
  }
  // The plane's vectors come in single precision, and are only nearly perpendicular. In double
  // precision they are made perpendicular again; an oblique plane then contains the chord exactly.
  first_ = unit_beside(plane_.oblique() ? travel_ : first_, {});
  second_ = unit_beside(second_, first_);
  const double x = dot(travel_, first_);
  const double y = dot(travel_, second_);
  chord_ = std::hypot(x, y);
  if (element.bulge != 0.0F && chord_ > 0.0) {
    half_sweep_ = 2.0 * std::atan(static_cast<double>(element.bulge));
    chord_angle_ = std::atan2(y, x);
  }
  plane_length_ = turns() ? chord_ * half_sweep_ / std::sin(half_sweep_) : chord_;
  off_plane_ = sum_of(travel_, -1.0, in_plane(travel_));
  length_ = std::hypot(norm(off_plane_), plane_length_);
}

Vector ExactBlock::in_plane(const Vector& vector) const {
  return seen_as(dot(vector, first_), dot(vector, second_));
}

Vector ExactBlock::seen_as(double x, double y) const {
  return sum_of(sum_of({}, x, first_), y, second_);
}

double ExactBlock::radius() const {
  return turns() ? chord_ / (2.0 * std::sin(std::abs(half_sweep_))) : 0.0;
}

Vector ExactBlock::place_at(double fraction) const {
  if (!turns()) return sum_of(start_, fraction, travel_);
  // Polar form of the chord of the first part of the arc: it lies half the part's sweep behind the
  // tangent at the part's end.
  const double part = chord_ * std::sin(half_sweep_ * fraction) / std::sin(half_sweep_);
  const double angle = chord_angle_ + half_sweep_ * (fraction - 1.0);
  const Vector round = seen_as(part * std::cos(angle), part * std::sin(angle));
  return sum_of(sum_of(start_, fraction, off_plane_), 1.0, round);
}

Vector ExactBlock::tangent_at(double fraction) const {
  if (!turns()) return divided(travel_, length_);
  const double angle = chord_angle_ + half_sweep_ * (2.0 * fraction - 1.0);
  const Vector round = seen_as(plane_share() * std::cos(angle), plane_share() * std::sin(angle));
  return sum_of(divided(off_plane_, length_), 1.0, round);
}

Vector ExactBlock::bend_at(double fraction) const {
  if (!turns()) return {};
  const double angle = chord_angle_ + half_sweep_ * (2.0 * fraction - 1.0);
  const double size = plane_share() * 2.0 * half_sweep_ / length_;
  return seen_as(-size * std::sin(angle), size * std::cos(angle));
}

/// Returns the length that F counts. Of an arc, it is the share of the length along X Y Z; with
/// rotary axes in its plane, that of its chord.
double ExactBlock::feed_length() const {
  const auto linear = [](const Vector& vector) {
    return std::sqrt(vector[0] * vector[0] + vector[1] * vector[1] + vector[2] * vector[2]);
  };
  const Vector chord = in_plane(travel_);
  const double share = norm(chord) > 0.0 ? linear(chord) / norm(chord) : 1.0;
  const double length =
      turns() ? std::hypot(linear(off_plane_), share * plane_length_) : linear(travel_);
  return length > 0.0 ? length : length_;
}

}  // namespace proof
