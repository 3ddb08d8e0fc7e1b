#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "planner/geometry/biarc.hpp"
#include "planner/geometry/curve_ahead.hpp"

namespace cnc {

/// A sampled part of a curve with which biarcs are compared.
///
/// Each point of the curve has a nearest point on the biarc. The nearest point advances with the
/// curve as long as the directions of the curve and of the biarc differ by less than a quarter turn
/// at the two points. Then each point of the curve has a counterpart on the biarc and vice versa,
/// and the deviation holds both ways (Hausdorff distance). No biarc is accepted if the directions
/// differ more at a sample, or if the curve turns by more than a sixth of a turn between two
/// samples.
class BiarcTrial {
 public:
  /// Number of inner samples; the two ends of the curve are not counted.
  static constexpr std::uint32_t kSamples = 24;
  /// Number of samples of the last, close comparison: ten times as many intervals.
  static constexpr std::uint32_t kClosely = 249;
  /// Deviation in mm that means that the biarc does not fit.
  static constexpr float kNoFit = 1.0e9F;

  struct Fit {
    float joint_share = 0.5F;
    float deviation_mm = kNoFit;
    std::uint32_t biarcs = 0;  ///< Number of biarcs that were compared with the curve.
  };

  /// Samples the curve from its present point to `distance` ahead, at equal steps of its parameter.
  void sample(CurveAhead& curve, float distance);

  /// Returns the biarc with the smallest deviation, or the first biarc found whose deviation is at
  /// most `enough_mm`. Searches all joint shares from kFirstShare to 1 − kFirstShare, to a
  /// hundredth.
  [[nodiscard]] Fit best(float enough_mm) const;
  /// Returns the deviation of the biarc whose joint is at `joint_share`, mm.
  [[nodiscard]] float deviation(float joint_share) const;
  /// Returns the deviation of the biarc whose joint is at `joint_share`, measured with kClosely
  /// samples, mm.
  /// @param curve the curve that was sampled last
  [[nodiscard]] float deviation_closely(CurveAhead& curve, float joint_share) const;
  /// Returns the deviation of the straight line from end to end, mm.
  [[nodiscard]] float deviation_of_line() const;

  [[nodiscard]] BiarcEnds ends() const {
    return {.start = {0.0F, 0.0F},
            .start_tangent = {1.0F, 0.0F},
            .end = end_,
            .end_tangent = end_tangent_};
  }
  /// Returns the greatest distance of the samples and of the end from the start of the curve, mm.
  /// It is at least the length of the chord.
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
