#pragma once

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <vector>

#include "host-sim/surface/mesh.hpp"
#include "tests/support/random_source.hpp"

/// Closed solids for tests, mm.
namespace sim::wall {

/// Appends a quadrilateral that is counter-clockwise as seen from outside.
inline void add_quad(surface::Mesh& mesh, const std::array<Eigen::Vector3d, 4>& corners) {
  std::array<std::uint32_t, 4> numbers{};
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const auto found = std::ranges::find(mesh.points, corners[i]);
    numbers[i] = static_cast<std::uint32_t>(found - mesh.points.begin());
    if (found == mesh.points.end()) mesh.points.push_back(corners[i]);
  }
  mesh.facets.push_back({numbers[0], numbers[1], numbers[2]});
  mesh.facets.push_back({numbers[0], numbers[2], numbers[3]});
}

/// Returns the corners of a square around the origin at a height.
inline std::array<Eigen::Vector3d, 4> square_at(double half, double height) {
  return {Eigen::Vector3d{-half, -half, height},
          Eigen::Vector3d{half, -half, height},
          Eigen::Vector3d{half, half, height},
          Eigen::Vector3d{-half, half, height}};
}

/// Appends the sides between two squares, with normals outwards for a solid within them.
inline void add_sides(surface::Mesh& mesh,
                      const std::array<Eigen::Vector3d, 4>& low,
                      const std::array<Eigen::Vector3d, 4>& high) {
  for (std::size_t i = 0; i < 4; ++i) {
    const std::size_t j = (i + 1) % 4;
    add_quad(mesh, {low[i], low[j], high[j], high[i]});
  }
}

/// Returns a block with a square pocket: its floor is at Z 0, its top at `depth`.
inline surface::Mesh pocket_solid(double inner, double outer, double depth) {
  surface::Mesh mesh;
  const auto floor = square_at(inner / 2, 0.0);
  const auto rim = square_at(inner / 2, depth);
  const auto top = square_at(outer / 2, depth);
  const auto bottom = square_at(outer / 2, -5.0);
  add_quad(mesh, floor);
  add_quad(mesh, {bottom[3], bottom[2], bottom[1], bottom[0]});
  for (std::size_t i = 0; i < 4; ++i) {
    const std::size_t j = (i + 1) % 4;
    add_quad(mesh, {floor[j], floor[i], rim[i], rim[j]});
    add_quad(mesh, {rim[i], top[i], top[j], rim[j]});
  }
  add_sides(mesh, bottom, top);
  return mesh;
}

/// Returns a vertical prism over a convex counter-clockwise polygon.
inline surface::Mesh prism_solid(const std::vector<Eigen::Vector2d>& polygon,
                                 double low,
                                 double high) {
  surface::Mesh mesh;
  const auto count = static_cast<std::uint32_t>(polygon.size());
  for (const double height : {low, high}) {
    for (const auto& place : polygon) mesh.points.emplace_back(place.x(), place.y(), height);
  }
  for (std::uint32_t i = 0; i < count; ++i) {
    const std::uint32_t j = (i + 1) % count;
    mesh.facets.push_back({i, j, count + j});
    mesh.facets.push_back({i, count + j, count + i});
    if (i == 0 || j == 0) continue;
    mesh.facets.push_back({0, j, i});
    mesh.facets.push_back({count, count + i, count + j});
  }
  return mesh;
}

/// Returns a lump: a ball of rings whose points are displaced at random to integer coordinates, so
/// that many are at one height.
inline surface::Mesh random_lump(proof::Random& random) {
  constexpr std::uint32_t kRings = 5;
  constexpr std::uint32_t kPoints = 7;
  surface::Mesh mesh;
  for (std::uint32_t ring = 1; ring <= kRings; ++ring) {
    for (std::uint32_t i = 0; i < kPoints; ++i) {
      const double across = std::numbers::pi * ring / (kRings + 1);
      const double turn = 2.0 * std::numbers::pi * i / kPoints;
      const double radius = random.between(4.0, 12.0);
      mesh.points.emplace_back(std::round(radius * std::sin(across) * std::cos(turn)),
                               std::round(radius * std::sin(across) * std::sin(turn)),
                               std::round(radius * std::cos(across)));
    }
  }
  const auto top = static_cast<std::uint32_t>(mesh.points.size());
  mesh.points.emplace_back(0.0, 0.0, 13.0);
  mesh.points.emplace_back(0.0, 0.0, -13.0);
  for (std::uint32_t i = 0; i < kPoints; ++i) {
    const std::uint32_t j = (i + 1) % kPoints;
    mesh.facets.push_back({top, i, j});
    mesh.facets.push_back({top + 1, (kRings - 1) * kPoints + j, (kRings - 1) * kPoints + i});
    for (std::uint32_t ring = 0; ring + 1 < kRings; ++ring) {
      const std::uint32_t upper = ring * kPoints;
      const std::uint32_t lower = upper + kPoints;
      mesh.facets.push_back({upper + i, lower + i, lower + j});
      mesh.facets.push_back({upper + i, lower + j, upper + j});
    }
  }
  return mesh;
}

/// Facets that a vertical line passes above a height.
struct Passed {
  int balance = 0;  ///< Facets that face up minus those that face down.
  int count = 0;
};

/// Returns the facets above a point. For a point within the solid, the balance is above 0. The line
/// must not pass through edges.
inline Passed passed_above(const surface::Mesh& mesh, const Eigen::Vector3d& point) {
  Passed passed;
  for (const auto& [a, b, c] : mesh.facets) {
    const std::array<Eigen::Vector3d, 3> corners{mesh.points[a], mesh.points[b], mesh.points[c]};
    std::array<double, 3> areas{};
    for (std::size_t i = 0; i < 3; ++i) {
      const Eigen::Vector3d from = corners[(i + 1) % 3] - point;
      const Eigen::Vector3d to = corners[(i + 2) % 3] - point;
      areas[i] = from.x() * to.y() - from.y() * to.x();
    }
    const auto [least, most] = std::minmax({areas[0], areas[1], areas[2]});
    if (least < 0.0 && most > 0.0) continue;
    const double whole = areas[0] + areas[1] + areas[2];
    if (whole == 0.0) continue;
    double height = 0.0;
    for (std::size_t i = 0; i < 3; ++i) height += areas[i] / whole * corners[i].z();
    if (height <= point.z()) continue;
    ++passed.count;
    passed.balance += whole > 0.0 ? 1 : -1;
  }
  return passed;
}

}  // namespace sim::wall
