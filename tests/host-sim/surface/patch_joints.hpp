#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <sstream>
#include <string>
#include <vector>

namespace sim::surface::patch {

/// A patch as the export writes it, read and evaluated without the product's code.
struct ReadPatch {
  double u0 = 0.0, u1 = 0.0, v0 = 0.0, v1 = 0.0;
  std::array<std::array<Eigen::Vector3d, 4>, 4> points{};
};

inline std::vector<ReadPatch> read_patches(const std::string& text) {
  std::vector<ReadPatch> patches;
  std::istringstream lines{text};
  std::string word;
  while (lines >> word) {
    if (word != "patch") return {};
    ReadPatch patch;
    std::size_t number = 0;
    lines >> number >> patch.u0 >> patch.u1 >> patch.v0 >> patch.v1;
    if (number != patches.size()) return {};
    for (auto& row : patch.points) {
      for (Eigen::Vector3d& point : row) lines >> point.x() >> point.y() >> point.z();
    }
    if (!lines) return {};
    patches.push_back(patch);
  }
  return patches;
}

/// The point of a cubic and its derivative, by de Casteljau's algorithm.
struct CurvePoint {
  Eigen::Vector3d point = Eigen::Vector3d::Zero();
  Eigen::Vector3d slope = Eigen::Vector3d::Zero();
};

inline CurvePoint casteljau(std::array<Eigen::Vector3d, 4> b, double t) {
  for (std::size_t length = 3; length > 1; --length) {
    for (std::size_t i = 0; i < length; ++i) b[i] += t * (b[i + 1] - b[i]);
  }
  return {b[0] + t * (b[1] - b[0]), 3.0 * (b[1] - b[0])};
}

/// Point and normal of a patch at a row and column.
struct Tangency {
  Eigen::Vector3d point = Eigen::Vector3d::Zero();
  Eigen::Vector3d normal = Eigen::Vector3d::Zero();  ///< Unit normal, or 0 if there is none.
};

inline Tangency tangency_at(const ReadPatch& patch, double row, double column) {
  const double u = (row - patch.u0) / (patch.u1 - patch.u0);
  const double v = (column - patch.v0) / (patch.v1 - patch.v0);
  std::array<Eigen::Vector3d, 4> points{};
  std::array<Eigen::Vector3d, 4> slopes{};
  for (std::size_t i = 0; i < 4; ++i) {
    const CurvePoint along_v = casteljau(patch.points[i], v);
    points[i] = along_v.point;
    slopes[i] = along_v.slope;
  }
  const CurvePoint along_u = casteljau(points, u);
  const Eigen::Vector3d across = casteljau(slopes, u).point;
  const Eigen::Vector3d normal = along_u.slope.cross(across);
  const double least = 1.0e-7 * along_u.slope.norm() * across.norm();
  return {along_u.point, normal.norm() > least ? normal.normalized() : Eigen::Vector3d::Zero()};
}

/// Greatest errors of all joints.
struct JointErrors {
  std::size_t joints = 0;
  std::size_t joints_of_two_sizes = 0;  ///< Joints of patches with different lengths.
  double gap_mm = 0.0;
  double angle = 0.0;  ///< Angle between the normals, radians.
};

/// Compares two patches along a common border, from one row and column to another.
inline void compare_joint(const ReadPatch& a,
                          const ReadPatch& b,
                          const Eigen::Vector2d& from,
                          const Eigen::Vector2d& to,
                          JointErrors& errors) {
  for (int i = 0; i <= 16; ++i) {
    const Eigen::Vector2d place = from + i / 16.0 * (to - from);
    const Tangency here = tangency_at(a, place.x(), place.y());
    const Tangency there = tangency_at(b, place.x(), place.y());
    errors.gap_mm = std::max(errors.gap_mm, (here.point - there.point).norm());
    if (here.normal.isZero() || there.normal.isZero()) continue;
    errors.angle =
        std::max(errors.angle,
                 std::atan2(here.normal.cross(there.normal).norm(), here.normal.dot(there.normal)));
  }
}

/// Returns the errors at all borders that two patches share with equal numbers.
inline JointErrors joint_errors(const std::vector<ReadPatch>& patches) {
  JointErrors errors;
  for (const ReadPatch& a : patches) {
    for (const ReadPatch& b : patches) {
      const double u0 = std::max(a.u0, b.u0);
      const double u1 = std::min(a.u1, b.u1);
      const double v0 = std::max(a.v0, b.v0);
      const double v1 = std::min(a.v1, b.v1);
      const bool is_along_v = a.u1 == b.u0 && v0 < v1;
      const bool is_along_u = a.v1 == b.v0 && u0 < u1;
      if (!is_along_u && !is_along_v) continue;
      ++errors.joints;
      const double length_a = is_along_v ? a.v1 - a.v0 : a.u1 - a.u0;
      const double length_b = is_along_v ? b.v1 - b.v0 : b.u1 - b.u0;
      if (length_a != length_b) ++errors.joints_of_two_sizes;
      compare_joint(a,
                    b,
                    is_along_v ? Eigen::Vector2d{a.u1, v0} : Eigen::Vector2d{u0, a.v1},
                    is_along_v ? Eigen::Vector2d{a.u1, v1} : Eigen::Vector2d{u1, a.v1},
                    errors);
    }
  }
  return errors;
}

}  // namespace sim::surface::patch
