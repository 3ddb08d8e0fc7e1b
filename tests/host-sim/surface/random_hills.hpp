#pragma once

#include <cmath>
#include <cstdint>

#include "host-sim/surface/mesh.hpp"
#include "tests/support/random_source.hpp"

namespace sim::surface {

/// Appends two facets for each quadrilateral of a grid of points.
inline void add_facets(std::uint32_t rows, std::uint32_t columns, Mesh& mesh) {
  for (std::uint32_t row = 0; row + 1 < rows; ++row) {
    for (std::uint32_t column = 0; column + 1 < columns; ++column) {
      const std::uint32_t at = row * columns + column;
      mesh.facets.push_back({at, at + 1, at + columns + 1});
      mesh.facets.push_back({at, at + columns + 1, at + columns});
    }
  }
}

/// Returns hills on a grid whose points are displaced at random, sometimes with a vertical wall.
inline Mesh random_hills(proof::Random& random) {
  const std::uint32_t rows = 2 + static_cast<std::uint32_t>(random.below(20));
  const std::uint32_t columns = 2 + static_cast<std::uint32_t>(random.below(20));
  const double pitch = random.magnitude(0.1, 3.0);
  const double height = random.magnitude(0.01, 10.0);
  const double stir = random.chance(0.5) ? 0.0 : 0.45 * pitch;
  Mesh mesh;
  for (std::uint32_t row = 0; row < rows; ++row) {
    for (std::uint32_t column = 0; column < columns; ++column) {
      mesh.points.emplace_back(pitch * column + random.between(-stir, stir),
                               pitch * row + random.between(-stir, stir),
                               random.chance(0.1) ? height : random.between(0.0, height));
    }
  }
  add_facets(rows, columns, mesh);
  return mesh;
}

/// Returns waves on a regular grid, as of a smooth part that was measured.
inline Mesh random_waves(proof::Random& random, std::uint32_t count, double pitch_mm) {
  Mesh mesh;
  const double length = random.between(8.0, 30.0);
  const double height = random.between(0.5, 3.0);
  const double turn = random.between(0.0, 6.0);
  for (std::uint32_t row = 0; row < count; ++row) {
    for (std::uint32_t column = 0; column < count; ++column) {
      const double x = pitch_mm * column;
      const double y = pitch_mm * row;
      const double z = std::sin(6.283 * x / length + turn) * std::cos(5.1 * y / length);
      mesh.points.emplace_back(x, y, height * (z + 0.3 * std::sin(0.1 * x + 0.4 * y)));
    }
  }
  add_facets(count, count, mesh);
  return mesh;
}

}  // namespace sim::surface
