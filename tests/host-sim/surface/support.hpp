#pragma once

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <array>
#include <bit>
#include <cmath>
#include <concepts>
#include <cstdint>
#include <random>
#include <stdexcept>
#include <string>
#include <vector>

#include "host-sim/surface/read_surface.hpp"

namespace sim::surface {

using Facet = std::array<std::uint32_t, 3>;

/// Returns the message with which `bytes` are refused; an empty text if they are read.
inline std::string refusal_of(const std::string& bytes, const ReadOptions& options = {}) {
  try {
    static_cast<void>(read_surface(bytes, "f", options));
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return {};
}

/// Returns an irregular grid with a smooth surface, whose coordinates have three decimals.
inline PointGrid random_grid(std::uint64_t seed, std::size_t rows, std::size_t columns) {
  std::mt19937_64 random{seed};
  std::uniform_real_distribution<double> off{-0.1, 0.1};
  PointGrid grid{.rows = rows, .columns = columns, .points = {}};
  const auto rounded = [](double value) { return std::round(value * 1000.0) / 1000.0; };
  const double phase = 20.0 * off(random);
  for (std::size_t r = 0; r < rows; ++r) {
    for (std::size_t c = 0; c < columns; ++c) {
      const double x = static_cast<double>(c) + off(random);
      const double y = 1.5 * static_cast<double>(r) + off(random);
      grid.points.emplace_back(
          rounded(x), rounded(y), rounded(2.0 * std::sin(0.3 * x + phase) + 0.2 * y));
    }
  }
  return grid;
}

/// Returns the rows as text; `between` is added after each row but the last.
inline std::string xyz_of(const PointGrid& grid,
                          const std::string& between = "",
                          const std::string& separator = " ") {
  std::string text;
  for (std::size_t i = 0; i < grid.points.size(); ++i) {
    if (i > 0 && i % grid.columns == 0) text += between;
    const Eigen::Vector3d& point = grid.points[i];
    text += fmt::format("{}{}{}{}{}\n", point.x(), separator, point.y(), separator, point.z());
  }
  return text;
}

/// Returns the bytes of a number, the least significant first.
template <std::unsigned_integral Whole>
std::string little(Whole value) {
  std::string bytes;
  for (std::size_t i = 0; i < sizeof(Whole); ++i) {
    bytes += static_cast<char>(static_cast<std::uint64_t>(value) >> (8 * i) & 0xFFU);
  }
  return bytes;
}
inline std::string little(float value) { return little(std::bit_cast<std::uint32_t>(value)); }
inline std::string little(double value) { return little(std::bit_cast<std::uint64_t>(value)); }

/// Returns the bytes of a number, the most significant first.
template <typename Number>
std::string big(Number value) {
  const std::string bytes = little(value);
  return {bytes.rbegin(), bytes.rend()};
}

/// Returns a mesh with coordinates that a float represents exactly.
inline Mesh random_mesh(std::uint64_t seed, std::size_t rows = 4, std::size_t columns = 5) {
  Mesh mesh = triangulated(random_grid(seed, rows, columns));
  for (Eigen::Vector3d& point : mesh.points) point = point.cast<float>().cast<double>();
  return mesh;
}

inline std::string binary_stl_of(const Mesh& mesh, std::string header = "made by a test") {
  header.resize(80, ' ');
  std::string bytes = header + little(static_cast<std::uint32_t>(mesh.facets.size()));
  for (const auto& facet : mesh.facets) {
    bytes += std::string(12, '\0');
    for (const std::uint32_t corner : facet) {
      for (const double value : mesh.points[corner]) bytes += little(static_cast<float>(value));
    }
    bytes += std::string(2, '\0');
  }
  return bytes;
}

inline std::string ascii_stl_of(const Mesh& mesh) {
  std::string text = "solid part\n";
  for (const auto& facet : mesh.facets) {
    text += "  facet normal 0 0 1\n    outer loop\n";
    for (const std::uint32_t corner : facet) {
      const Eigen::Vector3d& point = mesh.points[corner];
      text += fmt::format("      vertex {} {} {}\n", point.x(), point.y(), point.z());
    }
    text += "    endloop\n  endfacet\n";
  }
  return text + "endsolid part\n";
}

/// Returns the corners of all facets in their order, to compare meshes that number their points
/// differently.
inline std::vector<std::array<double, 9>> corners_of(const Mesh& mesh) {
  std::vector<std::array<double, 9>> all;
  for (const auto& facet : mesh.facets) {
    std::array<double, 9> corners{};
    for (std::size_t i = 0; i < 9; ++i) {
      corners[i] = mesh.points[facet[i / 3]][static_cast<Eigen::Index>(i % 3)];
    }
    all.push_back(corners);
  }
  return all;
}

}  // namespace sim::surface
