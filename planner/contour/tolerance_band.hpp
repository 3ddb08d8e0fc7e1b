#pragma once

#include <cmath>
#include <cstddef>
#include <span>

#include "planner/contour/curve_samples.hpp"
#include "planner/geometry/tangent_circle.hpp"

namespace cnc::contour {

/// Where an arc begins, and beside which place of the curve: its number among the
/// samples, with a fraction between two of them.
struct BandStart {
  WideVec2 place{0.0, 0.0};
  WideVec2 tangent{1.0, 0.0};
  double sample = 0.0;

  [[nodiscard]] WideTangentCircle circle(double curvature) const {
    return {place, tangent, curvature};
  }
};

/// How far an arc stays within the band, as a number of a sample, and which.
struct BandReach {
  double sample = 0.0;
  double curvature = 0.0;
  bool arrives = false;  ///< At the curve's end.
};

/// All that lies within a tolerance of a sampled curve.
///
/// An arc from a given place in a given direction passes a sample at the signed
/// distance e if k = 2 (y + e) / (q² − e²), with q the sample seen from there and y
/// what of it is to the left. k grows with e, so each sample allows an interval of
/// curvatures, and the arc that stays longest is found by one walk over the samples
/// that narrows the interval until nothing is left of it.
///
/// Where it does, the curve is within a quarter turn of the arc's direction beside
/// it, so that distances count both ways.
class ToleranceBand {
 public:
  ToleranceBand(const CurvePiece& piece, std::span<const CurveSample> samples, double tolerance_mm)
      : piece_{&piece}, samples_{samples}, tolerance_mm_{tolerance_mm} {}

  [[nodiscard]] double tolerance_mm() const { return tolerance_mm_; }
  [[nodiscard]] double last() const { return static_cast<double>(samples_.size() - 1); }
  /// The curve's place, and the curve, beside a number of a sample.
  [[nodiscard]] double spans_at(double sample) const;
  [[nodiscard]] WayPoint point_at(double sample) const;
  [[nodiscard]] const CurveSample& sample(std::size_t index) const { return samples_[index]; }
  /// Where a circle that runs along the curve passes it there.
  [[nodiscard]] BandStart start_on(const WideTangentCircle& circle, double sample) const;

  /// The arc from there that stays longest within the band; of those that get as far as the
  /// sample before `stop`, the one in their middle.
  [[nodiscard]] BandReach farthest(const BandStart& start, double stop) const;
  [[nodiscard]] BandReach farthest(const BandStart& start) const { return farthest(start, last()); }
  /// Returns the distance of a place of the curve from a circle; kNoFit where the circle runs
  /// another way. Inline: most of the time of a fit is spent here.
  [[nodiscard]] static double distance(const WideTangentCircle& circle, const WayPoint& point) {
    if (agreement(circle, point) < 0.5 * kLeastAgreement) return kNoFit;
    return std::abs(circle.across(point.place));
  }
  /// The greatest of the samples between two places.
  [[nodiscard]] double deviation(const WideTangentCircle& circle, double from, double to) const;
  /// Stands for "does not fit at all", mm.
  static constexpr double kNoFit = 1.0e9;
  /// Between the curve and an arc beside it, at a sample: 75 degrees or so, so that between
  /// samples it is less than a quarter turn.
  static constexpr double kLeastAgreement = 0.25;

 private:
  /// Returns the cosine between the curve and a circle beside it, times 1 + k e.
  [[nodiscard]] static double agreement(const WideTangentCircle& circle, const WayPoint& point) {
    const WideVec2 q = point.place - circle.point;
    return point.tangent.dot(circle.tangent) - circle.curvature * cross(point.tangent, q);
  }

  const CurvePiece* piece_;
  std::span<const CurveSample> samples_;
  double tolerance_mm_;
};

}  // namespace cnc::contour
