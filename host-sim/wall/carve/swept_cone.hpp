#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <limits>
#include <optional>

namespace sim::wall {

/// The heights of an upright line that are within a body, mm.
struct HeightRange {
  double low = 0.0;
  double high = 0.0;
};

/// A cone that is cut off at both ends, about an axis that rises.
struct CutCone {
  Eigen::Vector3d axis = Eigen::Vector3d::UnitZ();  ///< Unit vector, z above 0.
  double radius_mm = 0.0;                           ///< At the tip, at least 0.
  double slope = 0.0;    ///< By which the radius grows along the axis: tan of the half angle.
  double from_mm = 0.0;  ///< Along the axis from the tip; the radius is at least 0 there.
  double until_mm = std::numeric_limits<double>::infinity();
};

/// The points that a cut cone passes while its tip moves along a line and its axis stays.
///
/// The heights on an upright line are exact but for rounding: with the way of the tip as a second
/// unknown they are a convex region of the plane, between lines and a conic, whose lowest and
/// highest points are among few candidates.
class SweptCone {
 public:
  /// @param way of the tip, of any length
  SweptCone(const CutCone& cone, const Eigen::Vector3d& from, const Eigen::Vector3d& way);

  /// Returns the heights at X, Y; nothing where the body is not. The upper one may be infinite.
  [[nodiscard]] std::optional<HeightRange> heights(double x, double y) const;

  /// Returns true only where the body has no point at X, Y up to a height, and soon: a plane that
  /// touches the side of the cone is between them.
  [[nodiscard]] bool misses_below(double x, double y, double z) const {
    const Eigen::Vector3d point = Eigen::Vector3d{x, y, z} - from_;
    const Eigen::Vector3d middle = point - 0.5 * way_;
    const Eigen::Vector3d out = middle - middle.dot(cone_.axis) * cone_.axis;
    const double length = out.norm();
    const Eigen::Vector3d normal = out - cone_.slope * length * cone_.axis;
    const double distance = normal.dot(point);
    const double nearest = distance - std::max(0.0, normal.dot(way_));
    return normal.z() <= 0.0 && nearest > cone_.radius_mm * length;
  }

  /// A circle of the plan.
  struct Disc {
    Eigen::Vector2d middle = Eigen::Vector2d::Zero();
    double radius_mm = 0.0;
  };
  /// Returns discs whose convex hull is around the plan of all points of the body below a height;
  /// nothing where there are none.
  [[nodiscard]] std::optional<std::array<Disc, 4>> plan_below(double top) const;

 private:
  /// The terms of the conic that depend on the upright line: heights h and shares s of the way with
  /// a_ h² + 2 b_ h s + c_ s² + 2 d h + 2 e s + g <= 0 are within the sides of the cone.
  struct Line {
    double along = 0.0;  ///< Along the axis, of the line's point at the height of the tip.
    double d = 0.0;
    double e = 0.0;
    double g = 0.0;
  };

  void take_share(const Line& line, double share, HeightRange& range) const;
  void take_tangents(const Line& line, HeightRange& range) const;
  void take_end(const Line& line,
                const Eigen::Vector2d& out,
                double along_mm,
                HeightRange& range) const;

  CutCone cone_;
  Eigen::Vector3d from_;
  Eigen::Vector3d way_;
  double square_;  ///< 1 and the square of the slope.
  double climb_;   ///< Part of the way along the axis.
  double a_;
  double b_;
  double c_;
};

}  // namespace sim::wall
