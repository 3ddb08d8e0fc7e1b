#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <limits>
#include <optional>

namespace sim::wall {

/// A range of heights, mm, for example those at which a vertical line is inside a body.
struct HeightRange {
  double low = 0.0;
  double high = 0.0;
};

/// A cone around a rising axis, cut off at both ends.
struct CutCone {
  Eigen::Vector3d axis = Eigen::Vector3d::UnitZ();  ///< Unit vector of the axis, z above 0.
  double radius_mm = 0.0;                           ///< Radius of the cone at the tip, at least 0.
  /// Increase of the radius per length along the axis: the tangent of the half angle.
  double slope = 0.0;
  /// Lower end of the cone along the axis, measured from the tip. The radius there is at least 0.
  double from_mm = 0.0;
  double until_mm = std::numeric_limits<double>::infinity();
};

/// The body that a cut cone sweeps while its tip moves along a line and its axis keeps its
/// direction.
///
/// The heights on a vertical line are exact except for rounding. Consider the pairs of a height and
/// a fraction of the tip's path for which the line is inside the cone. They form a convex region of
/// a plane. This region is bounded by lines and a conic, so that its lowest and highest points are
/// among few candidates.
class SweptCone {
 public:
  /// @param from start of the tip
  /// @param way displacement of the tip, of any length
  SweptCone(const CutCone& cone, const Eigen::Vector3d& from, const Eigen::Vector3d& way);

  /// Returns the range of heights of the body at X, Y; nothing if the body has no point there. The
  /// upper end may be infinite.
  [[nodiscard]] std::optional<HeightRange> heights(double x, double y) const;

  /// Returns true only if the body has no point at X, Y up to the height `z`. The check is fast and
  /// not exact: it tries a plane that touches the side of the cone and separates it from these
  /// points.
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

  /// A disc in plan.
  struct Disc {
    Eigen::Vector2d middle = Eigen::Vector2d::Zero();
    double radius_mm = 0.0;
  };
  /// Returns discs whose convex hull encloses, in plan, all points of the body below the height
  /// `top`; nothing if there are no such points.
  [[nodiscard]] std::optional<std::array<Disc, 4>> plan_below(double top) const;

 private:
  /// Terms of the conic that depend on the vertical line. A height h at a fraction s of the tip's
  /// path is within the side of the cone if a_ h² + 2 b_ h s + c_ s² + 2 d h + 2 e s + g <= 0.
  struct Line {
    /// Distance along the axis to the line's point at the height of the tip's start.
    double along = 0.0;
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
  double square_;  ///< 1 plus the square of the slope.
  double climb_;   ///< Component of the tip's displacement along the axis.
  double a_;
  double b_;
  double c_;
};

}  // namespace sim::wall
