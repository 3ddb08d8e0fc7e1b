#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

#include "host-sim/surface/patch/patch_surface.hpp"
#include "host-sim/surface/point_grid.hpp"
#include "tests/support/random_source.hpp"

namespace sim::surface::patch {

inline Eigen::Vector3d random_vector(proof::Random& random, double size) {
  return {random.between(-size, size), random.between(-size, size), random.between(-size, size)};
}

/// Returns a patch near a rectangle, whose control points are moved by a random distance.
inline BezierPatch random_patch(proof::Random& random) {
  const double width = random.magnitude(0.5, 50.0);
  const double length = random.magnitude(0.5, 50.0);
  const double height = random.magnitude(0.01, 20.0);
  const double stir = random.between(0.0, 0.1) * std::min(width, length);
  BezierPatch patch;
  for (std::size_t i = 0; i < 4; ++i) {
    for (std::size_t j = 0; j < 4; ++j) {
      patch.rows[i].controls[j] = Eigen::Vector3d{static_cast<double>(i) * length / 3.0,
                                                  static_cast<double>(j) * width / 3.0,
                                                  random.between(-height, height)} +
                                  random_vector(random, stir);
    }
  }
  return patch;
}

/// A twice continuously differentiable surface: uniform cubic B-splines with random heights, and
/// the same number of spans along X and Y.
class SculpturedSurface {
 public:
  SculpturedSurface(proof::Random& random, std::size_t spans, double amplitude_mm) : spans_{spans} {
    heights_.resize((spans + 3) * (spans + 3));
    for (double& height : heights_) height = random.between(-amplitude_mm, amplitude_mm);
  }

  /// @param x, y from 0 to 1
  [[nodiscard]] double height(double x, double y) const {
    const auto [first_x, by_x] = weights(x);
    const auto [first_y, by_y] = weights(y);
    double sum = 0.0;
    for (std::size_t i = 0; i < 4; ++i) {
      for (std::size_t j = 0; j < 4; ++j) {
        sum += by_x[i] * by_y[j] * heights_[(first_x + i) * (spans_ + 3) + first_y + j];
      }
    }
    return sum;
  }

  /// Returns points on the surface; `stir` is the fraction of the pitch by which X and Y are moved.
  [[nodiscard]] PointGrid grid(std::size_t rows,
                               std::size_t columns,
                               double pitch_mm,
                               proof::Random* stirred_by = nullptr) const {
    PointGrid grid{.rows = rows, .columns = columns, .points = {}};
    const double max_x = static_cast<double>(columns - 1);
    const double max_y = static_cast<double>(rows - 1);
    const auto stir = [&] { return stirred_by != nullptr ? stirred_by->between(-0.2, 0.2) : 0.0; };
    for (std::size_t row = 0; row < rows; ++row) {
      for (std::size_t column = 0; column < columns; ++column) {
        const double x = static_cast<double>(column) + stir();
        const double y = static_cast<double>(row) + stir();
        const double height_mm =
            height(std::clamp(x / max_x, 0.0, 1.0), std::clamp(y / max_y, 0.0, 1.0));
        grid.points.emplace_back(pitch_mm * x, pitch_mm * y, height_mm);
      }
    }
    return grid;
  }

 private:
  struct Weights {
    std::size_t first = 0;
    std::array<double, 4> by{};
  };

  [[nodiscard]] Weights weights(double share) const {
    const double place = share * static_cast<double>(spans_);
    const auto span = std::min(static_cast<std::size_t>(place), spans_ - 1);
    const double t = place - static_cast<double>(span);
    const double s = 1.0 - t;
    return {span,
            {s * s * s / 6.0,
             (3.0 * t * t * t - 6.0 * t * t + 4.0) / 6.0,
             (3.0 * s * s * s - 6.0 * s * s + 4.0) / 6.0,
             t * t * t / 6.0}};
  }

  std::size_t spans_;
  std::vector<double> heights_;
};

/// Returns a random grid, irregular or not, with noise or not.
inline PointGrid random_point_grid(proof::Random& random, std::size_t most) {
  const std::size_t rows = 2 + random.below(most - 1);
  const std::size_t columns = 2 + random.below(most - 1);
  const double pitch = random.magnitude(0.1, 3.0);
  const SculpturedSurface surface{
      random, 1 + random.below(6), pitch * static_cast<double>(most) * random.magnitude(0.01, 0.5)};
  PointGrid grid = surface.grid(rows, columns, pitch, random.chance(0.5) ? &random : nullptr);
  const double noise = random.chance(0.3) ? pitch * random.magnitude(0.001, 0.3) : 0.0;
  for (Eigen::Vector3d& point : grid.points) point.z() += random.between(-noise, noise);
  return grid;
}

}  // namespace sim::surface::patch
