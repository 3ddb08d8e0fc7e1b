#pragma once

#include "planner/base/axes.hpp"
#include "planner/base/scalar_math.hpp"
#include "planner/geometry/vector.hpp"

namespace cnc::kinematics {

/// A jet: a point on a path, mm, and its first and second derivatives with respect to the length of
/// the path.
struct PlaceJet {
  Vec3 place = Vec3::Zero();
  Vec3 first = Vec3::Zero();
  Vec3 second = Vec3::Zero();
};

/// An angle on a path, and its derivatives with respect to the length of the path, rad/mm and
/// rad/mm².
struct AngleJet {
  SinCos angle{0.0F, 1.0F};
  float first = 0.0F;
  float second = 0.0F;
};

/// Returns the angle with the opposite sign.
[[nodiscard]] inline SinCos opposite(const SinCos& angle) { return {-angle.sine, angle.cosine}; }
[[nodiscard]] inline AngleJet opposite(const AngleJet& angle) {
  return {opposite(angle.angle), -angle.first, -angle.second};
}

/// Returns a vector after a right-handed rotation about the axis X, Y or Z.
/// @param about index of the axis, 0…2
[[nodiscard]] inline Vec3 turned(std::size_t about, const SinCos& angle, const Vec3& vector) {
  const std::size_t first = (about + 1) % kLinearAxisCount;
  const std::size_t second = (about + 2) % kLinearAxisCount;
  Vec3 result = vector;
  const auto i = static_cast<Eigen::Index>(first);
  const auto j = static_cast<Eigen::Index>(second);
  result[i] = angle.cosine * vector[i] - angle.sine * vector[j];
  result[j] = angle.sine * vector[i] + angle.cosine * vector[j];
  return result;
}

/// Returns the cross product of the unit vector along an axis and a vector.
[[nodiscard]] inline Vec3 axis_cross(std::size_t about, const Vec3& vector) {
  const auto i = static_cast<Eigen::Index>((about + 1) % kLinearAxisCount);
  const auto j = static_cast<Eigen::Index>((about + 2) % kLinearAxisCount);
  Vec3 result = Vec3::Zero();
  result[i] = -vector[j];
  result[j] = vector[i];
  return result;
}

/// Returns a jet after a rotation about an axis by an angle that also changes along the path.
[[nodiscard]] inline PlaceJet turned(std::size_t about,
                                     const AngleJet& angle,
                                     const PlaceJet& jet) {
  const Vec3 across = axis_cross(about, jet.place);
  const Vec3 first = jet.first + angle.first * across;
  const Vec3 second = jet.second + 2.0F * angle.first * axis_cross(about, jet.first) +
                      square(angle.first) * axis_cross(about, across) + angle.second * across;
  return {.place = turned(about, angle.angle, jet.place),
          .first = turned(about, angle.angle, first),
          .second = turned(about, angle.angle, second)};
}

}  // namespace cnc::kinematics
