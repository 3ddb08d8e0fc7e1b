#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <vector>

#include "host-sim/surface/mesh.hpp"
#include "planner/surface/profile.hpp"

namespace proof {

/// Computes the height of a tool over a mesh without the code that it checks. Parts of edges under
/// the tool are tested by searching a concave function, and the inside of facets by the tool's
/// point of the same slope. Facets are found by cells of the plan instead of a tree. Lengths are
/// mm.
class DropOracle {
 public:
  static constexpr double kNothing = -std::numeric_limits<double>::infinity();

  /// @pre the mesh outlives this object
  DropOracle(const sim::surface::Mesh& mesh, const cnc::surface::Profile& profile)
      : mesh_{mesh}, tool_{profile} {
    for (const Eigen::Vector3d& point : mesh.points) {
      min_ = min_.cwiseMin(point.head<2>());
      max_ = max_.cwiseMax(point.head<2>());
    }
    const double area = (max_ - min_).maxCoeff();
    cell_ = std::max(area / kCells, 1.0e-9);
    cells_.resize(static_cast<std::size_t>(kCells + 1) * (kCells + 1));
    for (std::uint32_t i = 0; i < mesh.facets.size(); ++i) add(i);
  }

  /// Returns the height of the tip, or kNothing if no facet is under the tool.
  /// @param radius_change change of the tool's rim, for contacts that lie on the rim
  [[nodiscard]] double height(const Eigen::Vector2d& place, double radius_change = 0.0) const {
    const double radius = tool_.radius_mm + radius_change;
    const Eigen::Array2i low = cell_of(place.array() - radius);
    const Eigen::Array2i high = cell_of(place.array() + radius);
    double best = kNothing;
    for (int row = low.y(); row <= high.y(); ++row) {
      for (int column = low.x(); column <= high.x(); ++column) {
        for (const std::uint32_t facet : cells_[index_of(column, row)]) {
          best = std::max(best, height_on(facet, place, radius, best));
        }
      }
    }
    return best;
  }

 private:
  static constexpr int kCells = 24;
  using Corners = std::array<Eigen::Vector3d, 3>;

  static std::size_t index_of(int column, int row) {
    return static_cast<std::size_t>(row) * (kCells + 1) + static_cast<std::size_t>(column);
  }

  [[nodiscard]] Eigen::Array2i cell_of(const Eigen::Array2d& place) const {
    const Eigen::Array2d cells = (place - min_.array()) / cell_;
    return cells.max(0.0).min(static_cast<double>(kCells)).floor().cast<int>();
  }

  [[nodiscard]] Corners corners_of(std::uint32_t facet) const {
    const auto& [a, b, c] = mesh_.facets[facet];
    return {mesh_.points[a], mesh_.points[b], mesh_.points[c]};
  }

  void add(std::uint32_t facet) {
    const auto [a, b, c] = corners_of(facet);
    const Eigen::Array2i low =
        cell_of(a.head<2>().cwiseMin(b.head<2>()).cwiseMin(c.head<2>()).array());
    const Eigen::Array2i high =
        cell_of(a.head<2>().cwiseMax(b.head<2>()).cwiseMax(c.head<2>()).array());
    for (int row = low.y(); row <= high.y(); ++row) {
      for (int column = low.x(); column <= high.x(); ++column) {
        cells_[index_of(column, row)].push_back(facet);
      }
    }
  }

  /// Returns the height of the tool's lower side above its tip at a distance from its axis.
  [[nodiscard]] double lower_side(double distance) const {
    const double out = distance - tool_.flat_mm;
    if (out <= 0.0) return tool_.tip_mm;
    if (tool_.corner_mm > 0.0) {
      const double left = tool_.corner_mm * tool_.corner_mm - out * out;
      return tool_.tip_mm + tool_.corner_mm - std::sqrt(std::max(0.0, left));
    }
    return tool_.tip_mm + tool_.rise * out;
  }

  [[nodiscard]] double height_on(std::uint32_t facet,
                                 const Eigen::Vector2d& place,
                                 double radius,
                                 double best) const {
    const Corners corners = corners_of(facet);
    const double top = std::max({corners[0].z(), corners[1].z(), corners[2].z()});
    if (top - tool_.tip_mm <= best) return kNothing;
    double height = inside(corners, place, radius);
    for (std::size_t i = 0; i < 3; ++i) {
      height = std::max(height, on_edge(corners[i], corners[(i + 1) % 3], place, radius));
    }
    return height;
  }

  /// The height of the edge minus that of the tool is concave over the part that is under the tool.
  [[nodiscard]] double on_edge(const Eigen::Vector3d& from,
                               const Eigen::Vector3d& to,
                               const Eigen::Vector2d& place,
                               double radius) const {
    const Eigen::Vector2d beside = from.head<2>() - place;
    const Eigen::Vector2d way = (to - from).head<2>();
    const double a = way.squaredNorm();
    double low = 0.0;
    double high = 1.0;
    if (a > 0.0) {
      const double nearest = -beside.dot(way) / a;
      const double across = (beside + nearest * way).norm();
      if (across > radius) return kNothing;
      const double half = std::sqrt((radius - across) * (radius + across) / a);
      low = std::max(low, nearest - half);
      high = std::min(high, nearest + half);
      if (low > high) return kNothing;
    } else if (beside.norm() > radius) {
      return kNothing;
    }
    const auto above = [&](double share) {
      const Eigen::Vector3d point = from + share * (to - from);
      return point.z() - lower_side(std::min((point.head<2>() - place).norm(), radius));
    };
    // Only a round tool is steeper than 1 in 20, and a round tool is smooth where it touches.
    const double steepest = std::abs(to.z() - from.z()) + 20.0 * way.norm();
    double best = std::max(above(low), above(high));
    while ((high - low) * steepest > 1.0e-9 && high - low > 1.0e-15) {
      const double first = low + (high - low) * 0.45;
      const double second = low + (high - low) * 0.55;
      const double at_first = above(first);
      const double at_second = above(second);
      best = std::max({best, at_first, at_second});
      if (at_first < at_second) {
        low = first;
      } else {
        high = second;
      }
    }
    return best;
  }

  /// Returns the height at which the inside of the facet touches the point of the tool with the
  /// same slope.
  [[nodiscard]] double inside(const Corners& corners,
                              const Eigen::Vector2d& place,
                              double radius) const {
    const Eigen::Vector3d normal = (corners[1] - corners[0]).cross(corners[2] - corners[0]);
    if (normal.z() == 0.0) return kNothing;
    const Eigen::Vector2d gradient = -normal.head<2>() / normal.z();
    const double slope = gradient.norm();
    const double out = std::clamp(touching(slope), 0.0, radius);
    const Eigen::Vector2d point =
        slope > 0.0 ? Eigen::Vector2d{place + gradient * (out / slope)} : place;
    double least = 1.0;
    double most = -1.0;
    for (std::size_t i = 0; i < 3; ++i) {
      const Eigen::Vector2d corner = corners[i].head<2>();
      const Eigen::Vector2d edge = corners[(i + 1) % 3].head<2>() - corner;
      const Eigen::Vector2d seen = point - corner;
      const double side = edge.x() * seen.y() - edge.y() * seen.x();
      least = std::min(least, side);
      most = std::max(most, side);
    }
    const bool is_within = normal.z() > 0.0 ? least >= 0.0 : most <= 0.0;
    if (!is_within) return kNothing;
    const double distance = slope > 0.0 ? out : 0.0;
    return corners[0].z() + gradient.dot(point - corners[0].head<2>()) - lower_side(distance);
  }

  /// Returns the distance from the axis at which the tool is as steep as the slope.
  [[nodiscard]] double touching(double slope) const {
    if (tool_.corner_mm > 0.0) {
      return tool_.flat_mm + tool_.corner_mm * std::sin(std::atan(slope));
    }
    if (tool_.rise > 0.0 && slope < tool_.rise) return tool_.flat_mm;
    return std::numeric_limits<double>::infinity();
  }

  const sim::surface::Mesh& mesh_;
  cnc::surface::Profile tool_;
  Eigen::Vector2d min_ = Eigen::Vector2d::Constant(std::numeric_limits<double>::infinity());
  Eigen::Vector2d max_ = Eigen::Vector2d::Constant(-std::numeric_limits<double>::infinity());
  double cell_ = 1.0;
  std::vector<std::vector<std::uint32_t>> cells_;
};

}  // namespace proof
