#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "planner/geometry/biarc.hpp"
#include "planner/geometry/curve_ahead.hpp"

namespace cnc {

/// A stretch of curve, sampled, against which biarcs are held.
///
/// As long as the direction of the curve is within a quarter turn of the
/// arc's beside it, the nearest point on the biarc advances with the curve, so
/// that each has a point beside every point of the other and the distance
/// counts both ways (Hausdorff). Where that does not hold at a sample, or the
/// curve turns by more than a sixth of a turn between two, no biarc is taken.
class BiarcTrial {
 public:
  static constexpr std::uint32_t kSamples = 24;   ///< Inside; ends not counted.
  static constexpr std::uint32_t kClosely = 249;  ///< Ten times as many, for the last look.
  /// Stands for "does not fit at all", mm.
  static constexpr float kNoFit = 1.0e9F;

  struct Fit {
    float joint_share = 0.5F;
    float deviation_mm = kNoFit;
    std::uint32_t biarcs = 0;  ///< That were held against the curve for it.
  };

  /// The curve from where it is seen to `distance` ahead, at places equally far
  /// apart in its parameter.
  void sample(CurveAhead& curve, float distance);

  /// The biarc that stays nearest, or the first found within `enough_mm`; over
  /// all joint shares from kFirstShare to 1 − kFirstShare, to a hundredth.
  [[nodiscard]] Fit best(float enough_mm) const;
  /// Of the biarc from end to end whose joint lies at this share.
  [[nodiscard]] float deviation(float joint_share) const;
  /// The same with kClosely samples, of the curve last sampled.
  [[nodiscard]] float deviation_closely(CurveAhead& curve, float joint_share) const;
  /// Of the straight line from end to end, mm.
  [[nodiscard]] float deviation_of_line() const;

  [[nodiscard]] BiarcEnds ends() const {
    return {.start = {0.0F, 0.0F},
            .start_tangent = {1.0F, 0.0F},
            .end = end_,
            .end_tangent = end_tangent_};
  }
  /// How far the curve goes from where it begins, mm; at least the chord.
  [[nodiscard]] float extent() const { return extent_; }

 private:
  static constexpr float kFirstShare = 0.08F;

  std::array<CurvePoint, kSamples> samples_{};
  float distance_ = 0.0F;
  float extent_ = 0.0F;
  Vec2 end_{0.0F, 0.0F};
  Vec2 end_tangent_{1.0F, 0.0F};
  bool turns_gently_ = false;
};

}  // namespace cnc
