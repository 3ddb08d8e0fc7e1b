#include "planner/wall/beam.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "planner/base/wide_scalar_math.hpp"

namespace cnc::wall {
namespace {

constexpr double kInfinite = std::numeric_limits<double>::infinity();

/// A point in the coordinates of the beam: its coordinate along the axis, and the vector from the
/// axis to the point.
struct Seen {
  double along = 0.0;
  Eigen::Vector3d out = Eigen::Vector3d::Zero();
};

Seen seen_by(const Beam& beam, const Eigen::Vector3d& point) {
  const Eigen::Vector3d way = point - beam.tip;
  const double along = way.dot(beam.axis);
  return {along, way - along * beam.axis};
}

using Corners = std::array<Seen, 3>;

/// A part of a line in the coordinates of the beam. The line's parameter is the distance past the
/// point nearest to the axis.
class SeenLine {
 public:
  SeenLine(const Seen& from, const Seen& to) {
    const Eigen::Vector3d across = to.out - from.out;
    length_ = across.norm();
    climb_ = to.along - from.along;
    from_along_ = from.along;
    if (length_ == 0.0) {
      beside_ = from.out.norm();
      return;
    }
    const Eigen::Vector3d direction = across / length_;
    past_ = from.out.dot(direction);
    beside_ = (from.out - past_ * direction).norm();
  }

  /// Returns the least signed distance from the side of the beam's cone, over the points between
  /// the shares `begin` and `end` of the line.
  [[nodiscard]] double least(const Beam& beam, double begin, double end) const {
    double share = climb_ > 0.0 ? end : begin;
    // If the line rises along the axis less steeply than the side of the cone, one of its points is
    // nearest to the side.
    const double rise = climb_ * beam.sine;
    const double run = length_ * beam.cosine;
    if (std::abs(rise) < run) {
      const double nearest = beside_ * rise / std::sqrt((run - rise) * (run + rise));
      share = std::clamp((nearest - past_) / length_, begin, end);
    }
    const double past = past_ + share * length_;
    const double out = std::sqrt(beside_ * beside_ + past * past);
    return beam.cosine * out - beam.sine * (from_along_ + share * climb_);
  }

 private:
  double length_ = 0.0;  ///< Length of the line's projection onto a plane across the axis.
  double climb_ = 0.0;
  double from_along_ = 0.0;
  double beside_ = 0.0;
  double past_ = 0.0;
};

/// Returns the share of a line at which it crosses a plane across the axis.
/// @pre its ends are on different sides of the plane
double share_at(const Seen& from, const Seen& to, double along) {
  return (along - from.along) / (to.along - from.along);
}

/// Points where a triangle's edges cross a plane across the axis: none or two.
struct Crossing {
  std::array<Seen, 2> ends{};
  std::size_t count = 0;

  void add(const Seen& from, const Seen& to, double along) {
    if (count == ends.size() || (from.along > along) == (to.along > along)) return;
    const double share = share_at(from, to, along);
    ends[count++] = {along, from.out + share * (to.out - from.out)};
  }
};

/// Finds the least signed distance from the side of a beam, over all points between the planes of
/// tip and lens.
class LeastDistance {
 public:
  /// Creates a search. The planes are moved apart by the margin, so that rounding loses no point on
  /// a plane.
  explicit LeastDistance(const Beam& beam) : beam_{beam}, top_{beam.length_mm + kBeamMarginMm} {}

  void add_edge(const Seen& from, const Seen& to) {
    const double low = std::min(from.along, to.along);
    const double high = std::max(from.along, to.along);
    if (high < kBottom || low > top_) return;
    double begin = 0.0;
    double end = 1.0;
    if (low < kBottom) (to.along > from.along ? begin : end) = share_at(from, to, kBottom);
    if (high > top_) (to.along > from.along ? end : begin) = share_at(from, to, top_);
    min_ = std::min(min_, SeenLine{from, to}.least(beam_, begin, end));
    lens_.add(from, to, top_);
    tip_.add(from, to, kBottom);
  }

  /// Adds the lines in which the triangle crosses the planes of the beam's two ends.
  void add_planes() {
    for (const Crossing* crossing : {&lens_, &tip_}) {
      if (crossing->count < 2) continue;
      const SeenLine line{crossing->ends[0], crossing->ends[1]};
      min_ = std::min(min_, line.least(beam_, 0.0, 1.0));
    }
  }

  /// Adds the point where the axis crosses the triangle.
  void add_axis(const Corners& corners) {
    std::array<double, 3> areas{};
    for (std::size_t i = 0; i < 3; ++i) {
      areas[i] = corners[(i + 1) % 3].out.cross(corners[(i + 2) % 3].out).dot(beam_.axis);
    }
    const auto [low, high] = std::minmax({areas[0], areas[1], areas[2]});
    if (low < 0.0 && high > 0.0) return;
    const double whole = areas[0] + areas[1] + areas[2];
    // If the triangle is seen edge-on, its sides are nearer to the axis than rounding can resolve.
    constexpr double kRounding = 1.0e-13;
    double reach_square = 0.0;
    for (const Seen& corner : corners) {
      reach_square = std::max(reach_square, corner.out.squaredNorm());
    }
    if (std::abs(whole) <= kRounding * reach_square) return;
    double along = 0.0;
    for (std::size_t i = 0; i < 3; ++i) along += areas[i] / whole * corners[i].along;
    if (along >= kBottom && along <= top_) min_ = std::min(min_, -beam_.sine * along);
  }

  /// Returns the least distance. It subtracts the waist, which the collected distances do not
  /// contain.
  [[nodiscard]] double value() const { return min_ - beam_.cosine * beam_.waist_mm; }

 private:
  static constexpr double kBottom = -kBeamMarginMm;

  const Beam& beam_;
  double top_;
  double min_ = kInfinite;
  Crossing lens_;
  Crossing tip_;
};

Corners corners_of(const Beam& beam, const Triangle& triangle) {
  return {seen_by(beam, triangle.a), seen_by(beam, triangle.b), seen_by(beam, triangle.c)};
}

double clearance_of(const Beam& beam, const Corners& corners) {
  LeastDistance least{beam};
  for (std::size_t i = 0; i < 3; ++i) least.add_edge(corners[i], corners[(i + 1) % 3]);
  least.add_planes();
  least.add_axis(corners);
  return least.value();
}

/// Returns whether all corners are beyond a plane that is tangent to the side of the beam, in the
/// direction of the corners' centre. This test recognizes most triangles that the beam misses.
bool is_apart(const Beam& beam, const Corners& corners) {
  const auto& [a, b, c] = corners;
  const Eigen::Vector3d towards = a.out + b.out + c.out;
  const double nearest = std::min({beam.cosine * a.out.dot(towards),
                                   beam.cosine * b.out.dot(towards),
                                   beam.cosine * c.out.dot(towards)});
  const double highest = std::max({a.along, b.along, c.along});
  const double within = beam.sine * highest + beam.cosine * beam.waist_mm + kBeamMarginMm;
  return nearest > 0.0 && nearest * nearest > within * within * towards.squaredNorm();
}

}  // namespace

Beam Beam::along(const Eigen::Vector3d& tip,
                 const Eigen::Vector3d& axis,
                 double half_angle_rad,
                 double length_mm) {
  const WideSinCos half_angle = sin_cos(half_angle_rad);
  return {.tip = tip,
          .axis = axis.normalized(),
          .sine = half_angle.sine,
          .cosine = half_angle.cosine,
          .length_mm = length_mm};
}

double clearance(const Beam& beam, const Triangle& triangle) {
  return clearance_of(beam, corners_of(beam, triangle));
}

bool meets(const Beam& beam, const Triangle& triangle) {
  const Corners corners = corners_of(beam, triangle);
  if (is_apart(beam, corners)) return false;
  return clearance_of(beam, corners) <= kBeamMarginMm;
}

}  // namespace cnc::wall
