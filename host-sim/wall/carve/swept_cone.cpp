#include "host-sim/wall/carve/swept_cone.hpp"

#include <algorithm>
#include <cmath>

namespace sim::wall {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr double kEndlessMm = std::numeric_limits<double>::infinity();

/// Returns the lower and the upper root of a x² + 2 b x + c. If a is 0, returns the range in which
/// the polynomial is at most 0. Returns nothing if a > 0 and there is no root, or if a is 0 and
/// there is no range.
std::optional<HeightRange> roots_of(double a, double b, double c) {
  if (a == 0.0) {
    if (b == 0.0 && c > 0.0) return {};
    HeightRange range;
    range.low = -kEndlessMm;
    range.high = kEndlessMm;
    if (b < 0.0) range.low = -0.5 * c / b;
    if (b > 0.0) range.high = -0.5 * c / b;
    return range;
  }
  const double square = b * b - a * c;
  if (square < 0.0 && a > 0.0) return {};
  // For a line through the apex of a cone, the polynomial has a double root. If rounding makes the
  // discriminant `square` negative, it counts as 0.
  const double sum = -(b + std::copysign(std::sqrt(std::max(0.0, square)), b));
  const double near = sum == 0.0 ? 0.0 : c / sum;
  return HeightRange{std::min(near, sum / a), std::max(near, sum / a)};
}

void take(double height, HeightRange& range) {
  range.low = std::min(range.low, height);
  range.high = std::max(range.high, height);
}

}  // namespace

SweptCone::SweptCone(const CutCone& cone, const Vector3d& from, const Vector3d& way)
    : cone_{cone},
      from_{from},
      way_{way},
      square_{1.0 + cone.slope * cone.slope},
      climb_{way.dot(cone.axis)},
      a_{cone.axis.head<2>().squaredNorm() -
         cone.axis.z() * cone.axis.z() * cone.slope * cone.slope},
      b_{-way.z() + cone.axis.z() * climb_ * square_},
      c_{way.squaredNorm() - climb_ * climb_ * square_} {}

std::optional<HeightRange> SweptCone::heights(double x, double y) const {
  const Vector2d out = Vector2d{x, y} - from_.head<2>();
  const double along = out.dot(cone_.axis.head<2>());
  const double leaning = along * square_ + cone_.radius_mm * cone_.slope;
  const Line line{.along = along,
                  .d = -cone_.axis.z() * leaning,
                  .e = -out.dot(way_.head<2>()) + climb_ * leaning,
                  .g = out.squaredNorm() - along * along * square_ -
                       cone_.radius_mm * (2.0 * cone_.slope * along + cone_.radius_mm)};
  HeightRange range;
  range.low = kEndlessMm;
  range.high = -kEndlessMm;
  take_share(line, 0.0, range);
  take_share(line, 1.0, range);
  take_tangents(line, range);
  take_end(line, out, cone_.from_mm, range);
  if (cone_.until_mm < kEndlessMm) take_end(line, out, cone_.until_mm, range);
  if (range.low > range.high) return {};
  return HeightRange{range.low + from_.z(), range.high + from_.z()};
}

/// Extends `range` by the heights that are within the cone when the tip is at the fraction `share`
/// of its path.
void SweptCone::take_share(const Line& line, double share, HeightRange& range) const {
  const auto roots =
      roots_of(a_, b_ * share + line.d, (c_ * share + 2.0 * line.e) * share + line.g);
  if (!roots) return;
  // If the vertical line is steeper than the cone's side, it is inside the cone above the upper
  // root.
  const double first = a_ >= 0.0 ? roots->low : roots->high;
  double last = kEndlessMm;
  if (a_ >= 0.0) last = roots->high;
  const double start = line.along - climb_ * share;
  const double low = std::max(first, (cone_.from_mm - start) / cone_.axis.z());
  const double high = std::min(last, (cone_.until_mm - start) / cone_.axis.z());
  if (low > high) return;
  take(low, range);
  take(high, range);
}

/// Extends `range` by the extreme heights of the conic, at which a line of constant height touches
/// the conic.
void SweptCone::take_tangents(const Line& line, HeightRange& range) const {
  if (!(c_ > 0.0)) return;
  const auto roots =
      roots_of(a_ - b_ * b_ / c_, line.d - b_ * line.e / c_, line.g - line.e * line.e / c_);
  if (!roots) return;
  for (const double height : {roots->low, roots->high}) {
    if (std::isinf(height)) continue;
    const double share = -(b_ * height + line.e) / c_;
    const double along = line.along + cone_.axis.z() * height - climb_ * share;
    const bool is_in =
        share > 0.0 && share < 1.0 && along >= cone_.from_mm && along <= cone_.until_mm;
    if (is_in) take(height, range);
  }
}

/// Extends `range` by the heights at which the vertical line intersects the disc that ends the cone
/// at `along_mm`, for all positions of the tip.
void SweptCone::take_end(const Line& line,
                         const Vector2d& out,
                         double along_mm,
                         HeightRange& range) const {
  // At the fraction s of the tip's path, the line intersects the plane of the disc at the point
  // start + s · pace. Both vectors are relative to the disc's centre.
  const double start_height = (along_mm - line.along) / cone_.axis.z();
  const double pace_height = climb_ / cone_.axis.z();
  const Vector3d start = Vector3d{out.x(), out.y(), start_height} - along_mm * cone_.axis;
  const Vector3d pace = Vector3d{0.0, 0.0, pace_height} - way_;
  const double radius = cone_.radius_mm + cone_.slope * along_mm;
  const double square = pace.squaredNorm();
  const double rest = start.squaredNorm() - radius * radius;
  if (square == 0.0) {
    if (rest <= 0.0) take(start_height, range);
    return;
  }
  const auto roots = roots_of(square, start.dot(pace), rest);
  if (!roots) return;
  const double first = std::max(roots->low, 0.0);
  const double last = std::min(roots->high, 1.0);
  if (first > last) return;
  take(start_height + first * pace_height, range);
  take(start_height + last * pace_height, range);
}

std::optional<std::array<SweptCone::Disc, 4>> SweptCone::plan_below(double top) const {
  const double tilt_sine = cone_.axis.head<2>().norm();
  const double lowest = from_.z() + std::min(0.0, way_.z());
  // A point of the cone is lower than its foot on the axis by at most its distance from the axis
  // times the sine of the tilt.
  const double rise = cone_.axis.z() - cone_.slope * tilt_sine;
  const double room = top - lowest + cone_.radius_mm * tilt_sine;
  double until = rise > 0.0 ? room / rise : kEndlessMm;
  if (until < cone_.from_mm) return {};
  // Upper limit of the distance along the axis; every stock is smaller.
  constexpr double kWidestMm = 1.0e5;
  until = std::min({until, cone_.until_mm, kWidestMm});
  const Vector2d begin = from_.head<2>();
  const Vector2d end = begin + way_.head<2>();
  const Vector2d lean = cone_.axis.head<2>();
  const double narrow = cone_.radius_mm + cone_.slope * cone_.from_mm;
  const double wide = cone_.radius_mm + cone_.slope * until;
  return std::array<Disc, 4>{{{begin + cone_.from_mm * lean, narrow},
                              {end + cone_.from_mm * lean, narrow},
                              {begin + until * lean, wide},
                              {end + until * lean, wide}}};
}

}  // namespace sim::wall
