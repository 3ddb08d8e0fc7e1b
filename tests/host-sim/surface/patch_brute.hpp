#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <limits>
#include <vector>

#include "host-sim/surface/patch/patch_surface.hpp"

namespace sim::surface::patch {

/// Computes distances of points from a surface by trying every patch. It takes 9 × 9 samples of
/// each patch. From the best samples of all patches that could contain the nearest point, it
/// searches with steps that shrink to zero.
class BruteDistance {
 public:
  explicit BruteDistance(const PatchSurface& surface) : surface_{surface} {}

  [[nodiscard]] double distance(const Eigen::Vector3d& point) const {
    std::vector<Start> starts;
    double best = std::numeric_limits<double>::infinity();
    for (const GridPatch& patch : surface_.patches) {
      Start start{.shape = &patch.shape};
      for (int i = 0; i <= kSamples; ++i) {
        for (int j = 0; j <= kSamples; ++j) {
          try_place(
              start, point, i / static_cast<double>(kSamples), j / static_cast<double>(kSamples));
        }
      }
      best = std::min(best, start.distance);
      starts.push_back(start);
    }
    std::sort(starts.begin(), starts.end(), [](const Start& a, const Start& b) {
      return a.distance < b.distance;
    });
    for (Start& start : starts) {
      if (start.distance > best + 0.5 * size_of(*start.shape)) continue;
      best = std::min(best, refined(start, point));
    }
    return best;
  }

 private:
  static constexpr int kSamples = 8;

  struct Start {
    const BezierPatch* shape = nullptr;
    double u = 0.0;
    double v = 0.0;
    double distance = std::numeric_limits<double>::infinity();
  };

  static bool try_place(Start& start, const Eigen::Vector3d& point, double u, double v) {
    const double distance = (point - start.shape->at(u, v)).norm();
    if (!(distance < start.distance)) return false;
    start.u = u;
    start.v = v;
    start.distance = distance;
    return true;
  }

  static double size_of(const BezierPatch& shape) {
    return std::max((shape.control(3, 3) - shape.control(0, 0)).norm(),
                    (shape.control(3, 0) - shape.control(0, 3)).norm());
  }

  static double refined(Start start, const Eigen::Vector3d& point) {
    double step = 1.0 / kSamples;
    while (step > 1.0e-9) {
      const Start from = start;
      for (int i = -1; i <= 1; ++i) {
        for (int j = -1; j <= 1; ++j) {
          try_place(start,
                    point,
                    std::clamp(from.u + i * step, 0.0, 1.0),
                    std::clamp(from.v + j * step, 0.0, 1.0));
        }
      }
      if (start.distance == from.distance) step *= 0.5;
    }
    return start.distance;
  }

  const PatchSurface& surface_;
};

}  // namespace sim::surface::patch
