#pragma once

#include <cmath>
#include <cstddef>
#include <span>

#include "planner/contour/curve_samples.hpp"
#include "planner/geometry/tangent_circle.hpp"

namespace cnc::contour {

/// The start of an arc, and the position along the curve next to it, counted in samples. The
/// position has a fraction between two samples.
struct BandStart {
  WideVec2 place{0.0, 0.0};
  WideVec2 tangent{1.0, 0.0};
  double sample = 0.0;

  [[nodiscard]] WideTangentCircle circle(double curvature) const {
    return {place, tangent, curvature};
  }
};

/// The position along the curve, in samples with a fraction, up to which an arc stays within the
/// band, and the arc's curvature.
struct BandReach {
  double sample = 0.0;
  double curvature = 0.0;
  bool arrives = false;  ///< Whether the arc reaches the curve's end.
};

/// All points within a tolerance of a sampled curve.
///
/// An arc from a given point in a given direction passes a sample at the signed distance e if k = 2
/// (y + e) / (q² − e²). Here k is the arc's curvature, q the vector from its start to the sample,
/// and y the component of q to the left of the direction. k grows with e, so each sample allows an
/// interval of curvatures. One pass over the samples narrows the interval until it is empty. The
/// last curvature in it belongs to the arc that stays in the band longest.
///
/// Wherever an arc is accepted, the curve's direction differs from the arc's direction by less than
/// a quarter turn. So the tolerance holds from the curve to the arc and from the arc to the curve.
class ToleranceBand {
 public:
  ToleranceBand(const CurvePiece& piece, std::span<const CurveSample> samples, double tolerance_mm)
      : piece_{&piece}, samples_{samples}, tolerance_mm_{tolerance_mm} {}

  [[nodiscard]] double tolerance_mm() const { return tolerance_mm_; }
  [[nodiscard]] double last() const { return static_cast<double>(samples_.size() - 1); }
  /// Returns the parameter, in spans, at a position counted in samples, or the curve's point there.
  [[nodiscard]] double spans_at(double sample) const;
  [[nodiscard]] WayPoint point_at(double sample) const;
  [[nodiscard]] const CurveSample& sample(std::size_t index) const { return samples_[index]; }
  /// Returns the point of `circle` next to the curve's point at `sample`, and the circle's tangent
  /// at that point.
  [[nodiscard]] BandStart start_on(const WideTangentCircle& circle, double sample) const;

  /// Returns the arc from `start` that stays longest within the band, at most up to the position
  /// `stop`. If several arcs reach the last sample before `stop`, returns the arc in the middle of
  /// the allowed curvatures.
  [[nodiscard]] BandReach farthest(const BandStart& start, double stop) const;
  [[nodiscard]] BandReach farthest(const BandStart& start) const { return farthest(start, last()); }
  /// Returns the distance of a point of the curve from a circle; kNoFit if the directions of the
  /// circle and of the curve differ too much. The function is inline, because most of the time of a
  /// fit is spent here.
  [[nodiscard]] static double distance(const WideTangentCircle& circle, const WayPoint& point) {
    if (agreement(circle, point) < 0.5 * kMinAgreement) return kNoFit;
    return std::abs(circle.across(point.place));
  }
  /// Returns the greatest distance between the circle and the samples between `from` and `to`.
  [[nodiscard]] double deviation(const WideTangentCircle& circle, double from, double to) const;
  /// Distance in mm that means that the circle does not fit.
  static constexpr double kNoFit = 1.0e9;
  /// Least cosine of the angle between the curve and an arc next to it, at a sample. It corresponds
  /// to about 75 degrees, so that between samples the angle stays below a quarter turn.
  static constexpr double kMinAgreement = 0.25;

 private:
  /// Returns the cosine of the angle between the curve and a circle next to it, times 1 + k e. Here
  /// k is the circle's curvature, and e the distance of the point from the circle.
  [[nodiscard]] static double agreement(const WideTangentCircle& circle, const WayPoint& point) {
    const WideVec2 q = point.place - circle.point;
    return point.tangent.dot(circle.tangent) - circle.curvature * cross(point.tangent, q);
  }

  const CurvePiece* piece_;
  std::span<const CurveSample> samples_;
  double tolerance_mm_;
};

}  // namespace cnc::contour
