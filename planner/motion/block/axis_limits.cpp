#include "planner/motion/block/axis_limits.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "planner/base/scalar_math.hpp"

namespace cnc::motion {
namespace {

constexpr float kRadiansPerDegree = kPi / 180.0F;

/// Computes positions on a block, and their derivatives by path length.
class BlockWay {
 public:
  BlockWay(const Block& block, const Position& start) : block_{block}, start_{start} {
    if (block.turns()) per_mm_ = 2.0F * block.turn.half_sweep / block.length;
  }

  [[nodiscard]] float curvature() const { return block_.turn.plane_share * std::abs(per_mm_); }

  [[nodiscard]] kinematics::ToolCentre::Way at(float share) const {
    const float way = share * block_.length;
    if (!block_.turns()) {
      return {.place = moved_by(start_, scaled(way, block_.direction)), .first = block_.direction};
    }
    const SinCos begin = sin_cos(block_.turn.start_angle);
    const SinCos here = sin_cos(block_.turn.start_angle + way * per_mm_);
    const float radius = block_.turn.plane_share / per_mm_;
    const ArcPlane& plane = block_.turn.plane;
    const AxisVector in_plane =
        plane.vector({radius * (here.sine - begin.sine), radius * (begin.cosine - here.cosine)});
    return {.place = moved_by(start_, sum_of(in_plane, way, block_.direction)),
            .first = sum_of(
                block_.direction, block_.turn.plane_share, plane.vector({here.cosine, here.sine})),
            .second =
                scaled(block_.turn.plane_share * per_mm_, plane.vector({-here.sine, here.cosine}))};
  }

 private:
  const Block& block_;
  const Position& start_;
  float per_mm_ = 0.0F;  ///< Angle by which the path turns per mm of its length, in rad.
};

/// Returns the greatest sum of the rates of the rotary axes on a block, in rad per mm of path. The
/// rates are evaluated at three positions. An allowance for the positions between them is added.
float rotary_rate(const Block& block, const BlockWay& way) {
  constexpr std::array<float, 3> kShares{0.0F, 0.5F, 1.0F};
  // The sum of the changes of three rates is at most √3 times the change of the tangent.
  constexpr float kOfAllAxes = 1.7320508F;
  float greatest = 0.0F;
  for (const float share : kShares) {
    const AxisVector first = way.at(share).first;
    float rate = 0.0F;
    for (std::size_t axis = kLinearAxisCount; axis < kAxisCount; ++axis) {
      rate += std::abs(first[axis]);
    }
    greatest = std::max(greatest, rate);
  }
  const float between = kOfAllAxes * way.curvature() * 0.25F * block.length;
  return (greatest + between) * kRadiansPerDegree;
}

}  // namespace

// The motion of the axes is evaluated at kLooks positions, equally spaced. From any position of the
// block, the nearest of these is at most an eighth of the block's length away. Over this distance,
// a derivative changes by at most the distance times the bound of the next higher derivative.
AxisCourse axis_course(const Block& block,
                       const Position& start,
                       const kinematics::ToolCentre& centre) {
  constexpr int kLooks = 5;
  const BlockWay way{block, start};
  const float rate = rotary_rate(block, way);
  const float between = block.length / static_cast<float>(2 * (kLooks - 1));
  const float lever = centre.lever(start, block.length);
  AxisCourse course;
  for (int look = 0; look < kLooks; ++look) {
    const auto at = way.at(static_cast<float>(look) / static_cast<float>(kLooks - 1));
    const kinematics::PlaceJet jet = centre.axes_along(at);
    course.least = look == 0 ? jet.place : Vec3{course.least.cwiseMin(jet.place)};
    course.most = look == 0 ? jet.place : Vec3{course.most.cwiseMax(jet.place)};
    course.first = course.first.cwiseMax(jet.first.cwiseAbs());
    course.second = course.second.cwiseMax(jet.second.cwiseAbs());
  }
  const float third = kinematics::ToolCentre::third_derivative(lever, rate, way.curvature());
  course.second.array() += between * third;
  course.first += between * course.second;
  // Between two evaluated positions, the position of an axis deviates from the straight line
  // through them by at most ½ · between² · (greatest second derivative).
  const Vec3 beyond = 0.5F * square(between) * course.second;
  const float anywhere = 2.0F * lever + block.length;
  course.least -= beyond.cwiseMin(anywhere);
  course.most += beyond.cwiseMin(anywhere);
  return course;
}

void limit_axes(Block& block, const AxisCourse& course, const Limits& limits) {
  constexpr float kGreatestOverride = 2.0F;
  constexpr float kTurningShare = 0.5F;
  float speed_square = block.speed_limit_square;
  if (!block.is_rapid()) {
    speed_square = std::min(speed_square, square(kGreatestOverride * block.feed));
  }
  float steps_per_mm = 0.0F;
  for (std::size_t axis = 0; axis < kLinearAxisCount; ++axis) {
    const auto i = static_cast<Eigen::Index>(axis);
    const float first = course.first[i];
    const float second = course.second[i];
    const float rate = motor_rate(limits, axis);
    const float turning = kTurningShare * limits.acceleration_mm_s2[axis];
    if (square(rate) < speed_square * square(first)) speed_square = square(rate / first);
    if (turning < speed_square * second) speed_square = turning / second;
    steps_per_mm += first * limits.scale[axis].steps_per_mm();
  }
  for (std::size_t axis = kLinearAxisCount; axis < kAxisCount; ++axis) {
    steps_per_mm += limits.scale[axis].steps_per_mm() * std::abs(block.direction[axis]);
  }
  const float all = limits.steps_per_s_all_motors;
  if (square(all) < speed_square * square(steps_per_mm)) speed_square = square(all / steps_per_mm);
  block.speed_limit_square = std::min(block.speed_limit_square, speed_square);
  for (std::size_t axis = 0; axis < kLinearAxisCount; ++axis) {
    const auto i = static_cast<Eigen::Index>(axis);
    const float left = limits.acceleration_mm_s2[axis] - speed_square * course.second[i];
    if (left < block.acceleration * course.first[i]) block.acceleration = left / course.first[i];
  }
}

}  // namespace cnc::motion
