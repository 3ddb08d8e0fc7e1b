#include "planner/path/blend_deviation.hpp"

#include <algorithm>
#include <cmath>

#include "planner/geometry/arc.hpp"
#include "planner/geometry/tangent_circle.hpp"

namespace cnc::path {
namespace {

constexpr int kSamplesOfPart = 8;
constexpr float kMissed = 1.03F;
constexpr float kNoBiarc = 1.0e9F;

/// The two legs with the corner as their origin.
class Wedge {
 public:
  explicit Wedge(const Corner& corner)
      : before_{{0.0F, 0.0F}, corner.before.tangent, corner.before.curvature},
        after_{{0.0F, 0.0F}, corner.after.tangent, corner.after.curvature} {}

  [[nodiscard]] float distance_to(const Vec2& place) const {
    const float corner = place.norm();
    const bool beside_before = place.dot(before_.tangent) <= 0.0F;
    const bool beside_after = place.dot(after_.tangent) >= 0.0F;
    const float before = beside_before ? std::abs(before_.across(place)) : corner;
    const float after = beside_after ? std::abs(after_.across(place)) : corner;
    return std::min(before, after);
  }

 private:
  TangentCircle before_;
  TangentCircle after_;
};

/// Two arcs that meet smoothly, as legs from their outer ends.
class Rounding {
 public:
  Rounding(const BiarcEnds& ends, const Biarc& biarc)
      : joint_{biarc.joint}, joint_tangent_{biarc.joint_tangent} {
    const auto first = Arc::make(ends.start, biarc.joint, biarc.first_bulge);
    const auto second = Arc::make(biarc.joint, ends.end, biarc.second_bulge);
    if (!first.ok() || !second.ok()) return;
    first_ = {joint_tangent_, first.value().curvature(), first.value().length().in_mm_and_s(), {}};
    second_ = {
        joint_tangent_, second.value().curvature(), second.value().length().in_mm_and_s(), {}};
  }

  [[nodiscard]] bool exists() const { return first_.length > 0.0F && second_.length > 0.0F; }
  /// At −1…1: from the start by the joint to the end.
  [[nodiscard]] Vec2 at(float share) const {
    const Leg& leg = share < 0.0F ? first_ : second_;
    return joint_ + leg.place(share * leg.length);
  }
  [[nodiscard]] float distance_to(const Vec2& place) const {
    const bool before = (place - joint_).dot(joint_tangent_) < 0.0F;
    const Leg& leg = before ? first_ : second_;
    return std::abs(TangentCircle{joint_, joint_tangent_, leg.curvature}.across(place));
  }

 private:
  Vec2 joint_;
  Vec2 joint_tangent_;
  Leg first_{};
  Leg second_{};
};

}  // namespace

float blend_deviation(const Corner& corner, float trim_mm) {
  const BiarcEnds ends = ends_of(corner, trim_mm);
  const auto biarc = make_biarc(ends, 0.5F);
  if (!biarc.ok()) return kNoBiarc;
  const Wedge wedge{corner};
  const Rounding rounding{ends, biarc.value()};
  if (!rounding.exists()) return kNoBiarc;
  float greatest = rounding.distance_to(Vec2{0.0F, 0.0F});
  for (int i = 1 - kSamplesOfPart; i < kSamplesOfPart; ++i) {
    const float share = static_cast<float>(i) / static_cast<float>(kSamplesOfPart);
    greatest = std::max(greatest, wedge.distance_to(rounding.at(share)));
    const Leg& leg = i < 0 ? corner.before : corner.after;
    greatest = std::max(greatest, rounding.distance_to(leg.place(share * trim_mm)));
  }
  return kMissed * greatest;
}

}  // namespace cnc::path
