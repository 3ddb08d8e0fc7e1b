#pragma once

#include <Eigen/Core>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <optional>
#include <vector>

#include "host-sim/surface/mesh.hpp"
#include "host-sim/wall/carve/beam_strokes.hpp"
#include "host-sim/wall/obstacles.hpp"

namespace sim::wall {

using Loop = std::vector<Eigen::Vector2d>;

/// A pit in a block, or a post on a plate. Its walls connect a loop at the floor with one at the
/// rim, at Z 0, over the same angles. Loops are counter-clockwise, and all their points are visible
/// from the origin.
struct WalledPart {
  Loop floor;
  Loop rim;
  double depth_mm = 1.0;
  bool is_post = false;
  double size_mm = 1.0;  ///< Half the side of the block, mm.

  /// Returns the loop of the walls at a height between the floor and the rim.
  [[nodiscard]] Loop loop_at(double z) const {
    const double share = -z / depth_mm;
    Loop loop;
    for (std::size_t i = 0; i < rim.size(); ++i) {
      loop.push_back((1.0 - share) * rim[i] + share * floor[i]);
    }
    return loop;
  }

  /// Returns the part as a closed mesh, facets outwards. The plate or block below the floor is as
  /// thick as the pit is deep.
  [[nodiscard]] surface::Mesh mesh() const;
};

/// Returns a loop whose edges are moved outwards by a distance, inwards if negative.
inline Loop offset_loop(const Loop& loop, double distance_mm) {
  Loop moved;
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const auto normal = [&](std::size_t from) {
      const Eigen::Vector2d way = loop[(from + 1) % loop.size()] - loop[from];
      return Eigen::Vector2d{way.y(), -way.x()}.normalized();
    };
    const Eigen::Vector2d before = normal((i + loop.size() - 1) % loop.size());
    const Eigen::Vector2d behind = normal(i);
    moved.push_back(loop[i] + distance_mm / (1.0 + before.dot(behind)) * (before + behind));
  }
  return moved;
}

/// Returns a part whose walls lean by an angle: a post is wider at its bottom, a pit narrower.
inline WalledPart walled_part(const Loop& floor, bool is_post, double depth_mm, double draft_rad) {
  const double wider = (is_post ? -1.0 : 1.0) * depth_mm * std::tan(draft_rad);
  return {.floor = floor,
          .rim = offset_loop(floor, wider),
          .depth_mm = depth_mm,
          .is_post = is_post,
          .size_mm = 1.0};
}

inline surface::Mesh WalledPart::mesh() const {
  surface::Mesh mesh;
  const auto count = static_cast<std::uint32_t>(floor.size());
  const auto add_loop = [&mesh](const Loop& loop, double z) {
    for (const Eigen::Vector2d& point : loop) mesh.points.emplace_back(point.x(), point.y(), z);
  };
  Loop block;
  for (const Eigen::Vector2d& point : rim) {
    block.push_back(size_mm / point.cwiseAbs().maxCoeff() * point);
  }
  const double middle = is_post ? -depth_mm : 0.0;
  add_loop(is_post ? rim : floor, is_post ? 0.0 : -depth_mm);
  add_loop(is_post ? floor : rim, middle);
  add_loop(block, middle);
  add_loop(block, -2.0 * depth_mm);
  mesh.points.emplace_back(0.0, 0.0, is_post ? 0.0 : -depth_mm);
  mesh.points.emplace_back(0.0, 0.0, -2.0 * depth_mm);
  for (std::uint32_t i = 0; i < count; ++i) {
    const std::uint32_t next = (i + 1) % count;
    mesh.facets.push_back({4 * count, i, next});
    for (std::uint32_t ring = 0; ring < 3; ++ring) {
      const std::uint32_t in = ring * count;
      const std::uint32_t out = in + count;
      mesh.facets.push_back({in + i, out + i, out + next});
      mesh.facets.push_back({in + i, out + next, in + next});
    }
    mesh.facets.push_back({4 * count + 1, 3 * count + next, 3 * count + i});
  }
  return mesh;
}

/// Parameters for milling the walls of a part.
struct WallMilling {
  double half_angle_rad = 0.0;
  double layer_mm = 0.01;
  bool avoids = false;      ///< True for axes of least tilt; false for vertical axes.
  std::size_t samples = 8;  ///< Number of tips on each edge of a layer.
};

/// Returns the strokes of a part's walls: in each layer one along each edge of the loop at this
/// height, without the tips that are out of reach.
inline std::vector<BeamStroke> strokes_of(const WalledPart& part, const WallMilling& milling) {
  const Obstacles obstacles{part.mesh()};
  const TiltRules rules{.half_angle_rad = milling.half_angle_rad,
                        .max_rad = 60.0 * std::numbers::pi / 180.0};
  std::vector<BeamStroke> strokes;
  const auto layers = std::lround(part.depth_mm / milling.layer_mm);
  for (long layer = 1; layer <= layers; ++layer) {
    const double z = -part.depth_mm * static_cast<double>(layer) / static_cast<double>(layers);
    const Loop loop = part.loop_at(z);
    for (std::size_t i = 0; i < loop.size(); ++i) {
      strokes.emplace_back();
      for (std::size_t k = 0; k < milling.samples; ++k) {
        const double share = static_cast<double>(k) / static_cast<double>(milling.samples - 1);
        const Eigen::Vector2d at = loop[i] + share * (loop[(i + 1) % loop.size()] - loop[i]);
        const Eigen::Vector3d tip{at.x(), at.y(), z};
        std::optional<Beam> beam = Beam::along(tip, Eigen::Vector3d::UnitZ(), 0.1, 1.0);
        if (milling.avoids) beam = least_tilt(obstacles, tip, rules);
        // The axis swings with the beam off, as around a convex corner.
        constexpr double kSwingCosine = 0.9903;
        const bool swings = beam && !strokes.back().empty() &&
                            beam->axis.dot(strokes.back().back().axis) < kSwingCosine;
        if (swings) strokes.emplace_back();
        if (beam) {
          strokes.back().push_back({tip, beam->axis, 0.0});
        } else if (!strokes.back().empty()) {
          strokes.emplace_back();
        }
      }
      if (strokes.back().empty()) strokes.pop_back();
    }
  }
  return strokes;
}

}  // namespace sim::wall
