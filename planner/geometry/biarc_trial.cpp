#include "planner/geometry/biarc_trial.hpp"

#include <algorithm>
#include <cmath>

#include "planner/geometry/tangent_circle.hpp"

namespace cnc {
namespace {

float curvature_of(const Vec2& chord, float bulge) {
  return 4.0F * bulge / (chord.norm() * (1.0F + bulge * bulge));
}

/// Estimates the greatest magnitude of a function from values at equal intervals: it is the peak of
/// the parabola through the greatest value and its neighbours.
class Peak {
 public:
  void add(float value) {
    const float size = std::abs(middle_);
    if (size >= std::abs(last_) && size >= std::abs(value)) judge(value);
    last_ = middle_;
    middle_ = value;
  }
  [[nodiscard]] float greatest() const { return greatest_; }

 private:
  void judge(float next) {
    const float bend = last_ - 2.0F * middle_ + next;
    const float slope = next - last_;
    const float rise = bend != 0.0F ? slope * slope / (8.0F * std::abs(bend)) : 0.0F;
    greatest_ = std::max(greatest_, std::abs(middle_) + std::min(rise, std::abs(bend)));
  }

  float last_ = 0.0F;
  float middle_ = 0.0F;
  float greatest_ = 0.0F;
};

/// Compares points of a curve, in their order, with a biarc.
class Gauge {
 public:
  Gauge(const BiarcEnds& ends, const Biarc& biarc)
      : joint_{biarc.joint},
        joint_tangent_{biarc.joint_tangent},
        first_{ends.start, ends.start_tangent, curvature_of(biarc.joint, biarc.first_bulge)},
        second_{
            ends.end, ends.end_tangent, curvature_of(ends.end - biarc.joint, biarc.second_bulge)} {}

  /// Adds a point of the curve. Returns false if the curve's direction differs by more than a
  /// quarter turn from the direction of the arc next to the point.
  [[nodiscard]] bool add(const CurvePoint& point) {
    const bool before = (point.place - joint_).dot(joint_tangent_) < 0.0F;
    const TangentCircle& beside = before ? first_ : second_;
    peak_.add(beside.across(point.place));
    return beside.agrees(point.place, point.direction);
  }
  /// Returns the greatest deviation of the points, mm. @pre all points were added.
  [[nodiscard]] float deviation() {
    peak_.add(0.0F);
    return peak_.greatest();
  }

 private:
  Vec2 joint_;
  Vec2 joint_tangent_;
  TangentCircle first_;
  TangentCircle second_;
  Peak peak_;
};

bool turn_gently(const Vec2& a, const Vec2& b) {
  const float along = a.dot(b);
  return along > 0.0F && along * along >= 0.25F * a.squaredNorm() * b.squaredNorm();
}

}  // namespace

void BiarcTrial::sample(CurveAhead& curve, float distance) {
  const float step = distance / static_cast<float>(kSamples + 1);
  Vec2 before{1.0F, 0.0F};
  distance_ = distance;
  turns_gently_ = true;
  for (std::size_t i = 0; i < kSamples; ++i) {
    samples_[i] = curve.at(step * static_cast<float>(i + 1));
    turns_gently_ = turns_gently_ && turn_gently(before, samples_[i].direction);
    before = samples_[i].direction;
  }
  end_ = curve.at(distance).place;
  end_tangent_ = curve.arrival(distance);
  turns_gently_ = turns_gently_ && turn_gently(before, end_tangent_);
  float square = end_.squaredNorm();
  for (const CurvePoint& sample : samples_) square = std::max(square, sample.place.squaredNorm());
  extent_ = std::sqrt(square);
}

float BiarcTrial::deviation(float joint_share) const {
  const auto biarc = make_biarc(ends(), joint_share);
  if (!biarc.ok()) return kNoFit;
  Gauge gauge{ends(), biarc.value()};
  for (const CurvePoint& sample : samples_) {
    if (!gauge.add(sample)) return kNoFit;
  }
  return gauge.deviation();
}

float BiarcTrial::deviation_closely(CurveAhead& curve, float joint_share) const {
  const auto biarc = make_biarc(ends(), joint_share);
  if (!biarc.ok()) return kNoFit;
  Gauge gauge{ends(), biarc.value()};
  const float step = distance_ / static_cast<float>(kClosely + 1);
  for (std::size_t i = 0; i < kClosely; ++i) {
    if (!gauge.add(curve.at(step * static_cast<float>(i + 1)))) return kNoFit;
  }
  return gauge.deviation();
}

/// Searches by golden section, because the deviation first falls and then rises with a growing
/// joint share.
BiarcTrial::Fit BiarcTrial::best(float enough_mm) const {
  constexpr float kGolden = 0.618034F;
  constexpr int kMaxSteps = 8;
  // If the deviation at the middle exceeds `enough_mm` by more than this factor, no other share can
  // be good enough.
  constexpr float kHopeless = 12.0F;
  if (!turns_gently_) return {};
  Fit fit{.joint_share = 0.5F, .deviation_mm = deviation(0.5F), .biarcs = 1};
  const bool hopeless = fit.deviation_mm < kNoFit && fit.deviation_mm > kHopeless * enough_mm;
  if (fit.deviation_mm <= enough_mm || hopeless) return fit;
  float low = kFirstShare;
  float high = 1.0F - kFirstShare;
  Fit left{.joint_share = high - kGolden * (high - low)};
  Fit right{.joint_share = low + kGolden * (high - low)};
  left.deviation_mm = deviation(left.joint_share);
  right.deviation_mm = deviation(right.joint_share);
  std::uint32_t biarcs = 3;
  for (int i = 0; i < kMaxSteps; ++i) {
    const Fit& better = left.deviation_mm < right.deviation_mm ? left : right;
    if (better.deviation_mm < fit.deviation_mm) fit = better;
    if (fit.deviation_mm <= enough_mm) break;
    ++biarcs;
    if (left.deviation_mm < right.deviation_mm) {
      high = right.joint_share;
      right = left;
      left.joint_share = high - kGolden * (high - low);
      left.deviation_mm = deviation(left.joint_share);
    } else {
      low = left.joint_share;
      left = right;
      right.joint_share = low + kGolden * (high - low);
      right.deviation_mm = deviation(right.joint_share);
    }
  }
  fit.biarcs = biarcs;
  return fit;
}

float BiarcTrial::deviation_of_line() const {
  const float square = end_.squaredNorm();
  float greatest = 0.0F;
  for (const CurvePoint& sample : samples_) {
    const float share = square > 0.0F ? sample.place.dot(end_) / square : 0.0F;
    const Vec2 nearest = std::clamp(share, 0.0F, 1.0F) * end_;
    greatest = std::max(greatest, (sample.place - nearest).norm());
  }
  return greatest;
}

}  // namespace cnc
