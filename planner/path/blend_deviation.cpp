#include "planner/path/blend_deviation.hpp"

#include <algorithm>
#include <cmath>

#include "planner/path/space_biarc.hpp"

namespace cnc::path {
namespace {

constexpr int kSamplesOfPart = 6;
constexpr float kMissed = 1.03F;
constexpr float kNoBlend = 1.0e9F;

/// Returns the distance of a point from a curve. The result is the distance from the tangent at a
/// point of the curve, plus the distance by which the curve bends away from this tangent.
/// @param offset vector to the given point from a point of the curve that is nearly the nearest
/// @param direction, curvature unit tangent and curvature, 1/mm, at this point of the curve
float distance_beside(const AxisVector& offset, const AxisVector& direction, float curvature) {
  const float along = dot(offset, direction);
  const float across = std::sqrt(std::max(0.0F, dot(offset, offset) - along * along));
  return across + 0.5F * std::abs(curvature) * along * along;
}

/// A point of the path and the corresponding point of the blend, to compute the distance of the
/// path's point from the blend and of the blend's point from the path.
struct Abreast {
  AxisVector offset{};     ///< Vector from the path's point to the blend's point.
  AxisVector direction{};  ///< Direction of the path at its point.
  float bend = 0.0F;       ///< Curvature of the path at its point, 1/mm.
  AxisVector blend_direction{};
  float blend_bend = 0.0F;

  [[nodiscard]] float distance() const {
    return std::max(distance_beside(offset, direction, bend),
                    distance_beside(offset, blend_direction, blend_bend));
  }
};

/// Compares each point of the blend with the point of the path at the same share of the length.
class Comparison {
 public:
  Comparison(const Corner& corner, float trim_mm)
      : corner_{corner},
        trim_mm_{trim_mm},
        from_{corner.before.place(-trim_mm)},
        to_{corner.after.place(trim_mm)} {
    const AxisVector start = corner.before.direction(-trim_mm);
    const AxisVector end = corner.after.direction(trim_mm);
    const AxisVector chord = sum_of(to_, -1.0F, from_);
    const auto joint = space_joint(start, chord, end);
    if (!joint) return;
    exists_ = true;
    first_ = leg_through(start, *joint);
    second_ = leg_through(end, sum_of(*joint, -1.0F, chord));
  }

  [[nodiscard]] bool exists() const { return exists_; }
  /// @param share share of the length from the start of the blend to the joint, 0…1
  [[nodiscard]] Abreast before(float share) const {
    return abreast(corner_.before, (share - 1.0F) * trim_mm_, from_, first_, share * first_.length);
  }
  /// @param share share of the length from the end of the blend back to the joint, 0…1
  [[nodiscard]] Abreast behind(float share) const {
    return abreast(corner_.after, (1.0F - share) * trim_mm_, to_, second_, -share * second_.length);
  }
  /// Returns the distance of the joint from the path near the corner. This is the distance from the
  /// leg that the joint is alongside or, if the joint is beyond the ends of both legs, from the
  /// corner itself.
  [[nodiscard]] float at_joint() const {
    const Abreast old = before(1.0F);
    const Abreast next = behind(1.0F);
    if (dot(old.offset, old.direction) <= 0.0F) return old.distance();
    if (dot(next.offset, next.direction) >= 0.0F) return next.distance();
    return norm(old.offset);
  }

 private:
  /// @param path_way distance of the point on the path after the corner, mm
  /// @param end end of the blend at which `blend` begins
  /// @param blend_way distance of the point on the blend after `end`, mm
  static Abreast abreast(
      const Leg& path, float path_way, const AxisVector& end, const Leg& blend, float blend_way) {
    const AxisVector place = sum_of(end, 1.0F, blend.place(blend_way));
    return {sum_of(place, -1.0F, path.place(path_way)),
            path.direction(path_way),
            path.bend(),
            blend.direction(blend_way),
            blend.bend()};
  }

  const Corner& corner_;
  float trim_mm_;
  AxisVector from_;
  AxisVector to_;
  Leg first_{};
  Leg second_{};
  bool exists_ = false;
};

}  // namespace

float blend_deviation(const Corner& corner, float trim_mm) {
  const Comparison comparison{corner, trim_mm};
  if (!comparison.exists()) return kNoBlend;
  float greatest = comparison.at_joint();
  for (int i = 1; i < kSamplesOfPart; ++i) {
    const float share = static_cast<float>(i) / static_cast<float>(kSamplesOfPart);
    greatest = std::max(
        {greatest, comparison.before(share).distance(), comparison.behind(share).distance()});
  }
  return kMissed * greatest;
}

}  // namespace cnc::path
