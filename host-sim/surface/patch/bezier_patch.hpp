#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>

namespace sim::surface::patch {

/// An interval of a parameter; by default the complete range from 0 to 1.
struct Interval {
  double from = 0.0;
  double to = 1.0;
};

/// A cubic Bézier curve in space; its parameter runs from 0 to 1.
struct BezierCurve {
  std::array<Eigen::Vector3d, 4> controls{Eigen::Vector3d::Zero(),
                                          Eigen::Vector3d::Zero(),
                                          Eigen::Vector3d::Zero(),
                                          Eigen::Vector3d::Zero()};

  [[nodiscard]] Eigen::Vector3d at(double t) const;
  /// Returns the part of the curve over `interval`, by de Casteljau's algorithm. If two intervals
  /// have a common end, both parts have the same point there to the last bit.
  [[nodiscard]] BezierCurve part(Interval interval) const;
};

/// A point of a patch, with the derivatives by the patch's parameters u and v.
struct PatchJet {
  Eigen::Vector3d point = Eigen::Vector3d::Zero();
  Eigen::Vector3d along_u = Eigen::Vector3d::Zero();
  Eigen::Vector3d along_v = Eigen::Vector3d::Zero();
  /// Mixed derivative with respect to both parameters.
  Eigen::Vector3d twist = Eigen::Vector3d::Zero();
};

/// A bicubic Bézier patch; both parameters run from 0 to 1. The 16 control points form four rows.
/// The index of a row belongs to u, the index within a row belongs to v.
struct BezierPatch {
  std::array<BezierCurve, 4> rows{};

  [[nodiscard]] const Eigen::Vector3d& control(std::size_t u, std::size_t v) const {
    return rows[u].controls[v];
  }
  [[nodiscard]] Eigen::Vector3d at(double u, double v) const;
  [[nodiscard]] PatchJet jet(double u, double v) const;
  /// Returns the curve along v at a fixed u.
  [[nodiscard]] BezierCurve curve_at_u(double u) const;
  /// Returns the curve along u at a fixed v.
  [[nodiscard]] BezierCurve curve_at_v(double v) const;

  /// Returns the part of the patch over the intervals `u` and `v`, by de Casteljau's algorithm. If
  /// two parts have a border with the same ends, its control points are equal to the last bit.
  [[nodiscard]] BezierPatch part(Interval u, Interval v) const;
  /// Returns the patch with exchanged parameters u and v.
  [[nodiscard]] BezierPatch transposed() const;
};

}  // namespace sim::surface::patch
