#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>

namespace sim::surface::patch {

/// A part of the interval of a parameter.
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
  /// Returns the same curve over a part of its parameter, by de Casteljau. If two intervals share
  /// an end, their curves share the point there to the last bit.
  [[nodiscard]] BezierCurve part(Interval interval) const;
};

/// The point of a patch with its derivatives with respect to the patch's own parameters.
struct PatchJet {
  Eigen::Vector3d point = Eigen::Vector3d::Zero();
  Eigen::Vector3d along_u = Eigen::Vector3d::Zero();
  Eigen::Vector3d along_v = Eigen::Vector3d::Zero();
  /// Mixed derivative with respect to both parameters.
  Eigen::Vector3d twist = Eigen::Vector3d::Zero();
};

/// A bicubic Bézier patch; both parameters run from 0 to 1. Its 16 control points are four rows:
/// the outer index belongs to u, the inner to v.
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

  /// Returns the same surface over a part of the parameters, by de Casteljau. Parts that share a
  /// border with the same ends share its control points to the last bit.
  [[nodiscard]] BezierPatch part(Interval u, Interval v) const;
  /// Returns the same surface with u and v exchanged.
  [[nodiscard]] BezierPatch transposed() const;
};

}  // namespace sim::surface::patch
