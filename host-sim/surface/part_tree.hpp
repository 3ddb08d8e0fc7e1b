#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "host-sim/surface/mesh.hpp"
#include "planner/surface/drop.hpp"

namespace sim::surface {

/// Facets sorted into parts of parts, eight at a time, each of which bounds how high a tool that
/// touches it can be. A part lies within a rectangle in plan, and not above a plane.
///
/// Bounds are computed in single precision, for eight parts at once, and are rounded up by more
/// than that can be off. All lengths are mm.
class PartTree {
 public:
  static constexpr std::size_t kParts = 8;
  static constexpr std::size_t kMostInALeaf = 4;
  /// Numbers of four parts, which processors compute at once.
  using Four = float __attribute__((vector_size(16)));
  struct Lanes {
    std::array<Four, kParts / 4> fours;
    [[nodiscard]] float operator[](std::size_t part) const { return fours[part / 4][part % 4]; }
    void set(std::size_t part, float value) { fours[part / 4][part % 4] = value; }
  };

  struct Node {
    Lanes least_x, least_y, most_x, most_y;
    Lanes top;               ///< No point is higher.
    Lanes slope_x, slope_y;  ///< The rise of the plane along X and Y.
    Lanes level;             ///< Height of the plane in the middle of the rectangle.
    Lanes point_x, point_y;  ///< From the tool's axis to its point that touches such a plane.
    std::array<std::uint32_t, kParts> first;  ///< A place in order(), or the number of a node.
    std::array<std::uint32_t, kParts> count;  ///< Facets from there; 0 where `first` is a node.
  };

  /// The tool in single precision.
  struct Shape {
    float reach_square = 0.0F;
    float almost = 0.0F;  ///< Distance up to which the tool's own tangents are taken.
    float flat = 0.0F;
    float corner = 0.0F;
    float rise = 0.0F;
  };

  /// @pre the mesh has a facet, and its indices are those of points
  PartTree(const Mesh& mesh, const cnc::surface::Profile& profile);

  /// Returns the facets' numbers, those of a leaf one after the other.
  [[nodiscard]] const std::vector<std::uint32_t>& order() const { return order_; }
  [[nodiscard]] const Node& node(std::uint32_t number) const { return nodes_[number]; }
  /// Returns for each part of a node a height that the tool's tip has at most where it touches it;
  /// -infinity where it does not reach it.
  [[nodiscard]] Lanes bounds(const Node& node, const Eigen::Vector2d& place) const;

 private:
  /// A run of order().
  struct Run {
    std::uint32_t first, count;
  };
  class Builder;

  std::vector<std::uint32_t> order_;
  std::vector<Node> nodes_;  ///< The first is the root.
  Shape tool_;
};

}  // namespace sim::surface
