#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <limits>
#include <optional>

namespace sim::wall {

/// The heights at which a vertical line is inside a body, mm.
struct HeightRange {
  double low = 0.0;
  double high = 0.0;
};

/// A cone that is cut off at both ends, about an axis that rises.
struct CutCone {
  Eigen::Vector3d axis = Eigen::Vector3d::UnitZ();  ///< Unit vector of the axis, z above 0.
  double radius_mm = 0.0;                           ///< Radius at the tip, at least 0.
  double slope = 0.0;  ///< Growth of the radius per length along the axis: tan of the half angle.
  /// Lower end along the axis, measured from the tip; the radius there is at least 0.
  double from_mm = 0.0;
  double until_mm = std::numeric_limits<double>::infinity();
};

/// The points that a cut cone passes while its tip moves along a line and its axis keeps its
/// direction.
///
/// The heights on a vertical line are exact apart from rounding. With the share of the tip's path
/// as a second unknown, they are a convex region of a plane, between lines and a conic. The lowest
/// and highest points of this region are among few candidates.
class SweptCone {
 public:
  /// @param from start of the tip
  /// @param way displacement of the tip, of any length
  SweptCone(const CutCone& cone, const Eigen::Vector3d& from, const Eigen::Vector3d& way);

  /// Returns the heights of the body at X, Y; nothing if the body is not there. The upper height
  /// may be infinite.
  [[nodiscard]] std::optional<HeightRange> heights(double x, double y) const;

  /// Returns true only if the body has no point at X, Y up to a height. The check is fast: it looks
  /// for a plane that touches the side of the cone and separates it from these points.
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
  /// Returns discs whose convex hull encloses the plan of all points of the body below a height;
  /// nothing if there are no such points.
  [[nodiscard]] std::optional<std::array<Disc, 4>> plan_below(double top) const;

 private:
  /// The terms of the conic that depend on the vertical line. Heights h and shares s of the tip's
  /// path are within the sides of the cone if a_ h² + 2 b_ h s + c_ s² + 2 d h + 2 e s + g <= 0.
  struct Line {
    double along = 0.0;  ///< Distance along the axis of the line's point at the height of the tip.
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
