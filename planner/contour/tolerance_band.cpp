#include "planner/contour/tolerance_band.hpp"

#include <algorithm>
#include <cmath>

namespace cnc::contour {
namespace {

/// Greatest sweep of an arc in radians. It is a little less than half a turn, so that a bulge stays
/// within ±1.
constexpr double kMaxSweep = 2.9;

std::size_t first_after(double sample) { return static_cast<std::size_t>(sample) + 1; }

struct CurvatureRange {
  double low = 0.0;
  double high = 0.0;

  void narrow(const CurvatureRange& by) {
    low = std::max(low, by.low);
    high = std::min(high, by.high);
  }
};

/// Returns the curvatures with which an arc from `start` passes the sample `point` within the band
/// and roughly in the direction of the curve.
CurvatureRange past(const BandStart& start, const WayPoint& point, double tolerance_mm) {
  const double most = 0.9 / tolerance_mm;
  CurvatureRange range{-most, most};
  const WideVec2 q = point.place - start.place;
  const double room = q.squaredNorm() - tolerance_mm * tolerance_mm;
  if (room > 0.0) {
    const double left = cross(start.tangent, q);
    range.narrow({2.0 * (left - tolerance_mm) / room, 2.0 * (left + tolerance_mm) / room});
  }
  // With the tangents n of the arc's start and N of the sample's point, agreement() is linear in
  // the curvature: n · N − k (N × q).
  const double along = start.tangent.dot(point.tangent) - ToleranceBand::kMinAgreement;
  const double slope = cross(point.tangent, q);
  if (slope > 0.0) range.narrow({-most, along / slope});
  if (slope < 0.0) range.narrow({along / slope, most});
  return range;
}

/// Returns the share of the distance between two samples after which the allowed curvatures are
/// outside the range `open`. The allowed range changes linearly from `from` to `to`.
double crossing(const CurvatureRange& from, const CurvatureRange& to, const CurvatureRange& open) {
  if (to.low > open.high) return (open.high - from.low) / (to.low - from.low);
  if (to.high < open.low) return (from.high - open.low) / (from.high - to.high);
  return 0.0;
}

}  // namespace

double ToleranceBand::spans_at(double sample) const {
  const auto index = std::min(static_cast<std::size_t>(sample), samples_.size() - 2);
  const double share = sample - static_cast<double>(index);
  const double from = samples_[index].spans;
  return std::min(from + share * (samples_[index + 1].spans - from), samples_.back().spans);
}

WayPoint ToleranceBand::point_at(double sample) const { return piece_->at(spans_at(sample)); }

BandStart ToleranceBand::start_on(const WideTangentCircle& circle, double sample) const {
  const WideVec2 place = point_at(sample).place;
  const WideVec2 towards_centre =
      left_normal(circle.tangent) - circle.curvature * (place - circle.point);
  const WideVec2 left = towards_centre.normalized();
  return {.place = place + circle.across(place) * left,
          .tangent = {left.y(), -left.x()},
          .sample = sample};
}

BandReach ToleranceBand::farthest(const BandStart& start, double stop) const {
  CurvatureRange open{-0.9 / tolerance_mm_, 0.9 / tolerance_mm_};
  CurvatureRange before = open;
  const std::size_t first = first_after(start.sample);
  const double turned = samples_[first - 1].turned;
  BandReach reach{.sample = start.sample};
  std::size_t i = first;
  for (; static_cast<double>(i) <= stop; ++i) {
    const CurveSample& sample = samples_[i];
    if (sample.turned - turned > kMaxSweep) break;
    const CurvatureRange now = past(start, sample.point, tolerance_mm_);
    CurvatureRange narrowed = open;
    narrowed.narrow(now);
    if (narrowed.low > narrowed.high) {
      const bool low = now.low > open.high;
      const double share = i == first ? 0.0 : crossing(before, now, open);
      reach.curvature = low ? open.high : open.low;
      reach.sample = std::max(start.sample, static_cast<double>(i - 1) + share);
      return reach;
    }
    open = narrowed;
    before = now;
  }
  reach.curvature = 0.5 * (open.low + open.high);
  reach.sample = static_cast<double>(i - 1);
  reach.arrives = i == samples_.size();
  return reach;
}

double ToleranceBand::deviation(const WideTangentCircle& circle, double from, double to) const {
  double greatest = 0.0;
  for (std::size_t i = first_after(from); static_cast<double>(i) < to; ++i) {
    greatest = std::max(greatest, distance(circle, samples_[i].point));
  }
  return greatest;
}

}  // namespace cnc::contour
