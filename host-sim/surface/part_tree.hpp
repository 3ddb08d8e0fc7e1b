#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "host-sim/surface/mesh.hpp"
#include "planner/surface/drop.hpp"

namespace sim::surface {

/// A tree of facets whose nodes have eight parts each. The facets of a part are within a rectangle
/// in plan and nowhere above a plane. The rectangle and the plane bound the height of a tool that
/// touches the part.
///
/// Bounds are computed in single precision for eight parts in parallel. They are increased by more
/// than their rounding error. All lengths are mm.
class PartTree {
 public:
  static constexpr std::size_t kParts = 8;
  static constexpr std::size_t kMaxInALeaf = 4;
  /// A value for each of four parts, in one vector register.
  using Four = float __attribute__((vector_size(16)));
  struct Lanes {
    std::array<Four, kParts / 4> fours;
    [[nodiscard]] float operator[](std::size_t part) const { return fours[part / 4][part % 4]; }
    void set(std::size_t part, float value) { fours[part / 4][part % 4] = value; }
  };

  struct Node {
    Lanes min_x, min_y, max_x, max_y;
    Lanes top;               ///< Height of the highest point of the part.
    Lanes slope_x, slope_y;  ///< Slopes of the part's plane along X and along Y.
    Lanes level;             ///< Height of the plane at the middle of the rectangle.
    /// Offset from the tool's axis to the point of the tool that touches the plane.
    Lanes point_x, point_y;
    /// Index of the part's first facet in order() if the part is a leaf, else the number of its
    /// node.
    std::array<std::uint32_t, kParts> first;
    /// Number of facets of a leaf; 0 if `first` is the number of a node.
    std::array<std::uint32_t, kParts> count;
  };

  /// The tool in single precision.
  struct Shape {
    float reach_square = 0.0F;
    /// Distance from the axis up to which tangents follow the tool's shape. Beyond this distance,
    /// the last tangent continues, because the tool is almost vertical there.
    float almost = 0.0F;
    float flat = 0.0F;
    float corner = 0.0F;
    float rise = 0.0F;
  };

  /// @pre the mesh has at least one facet, and all its indices are valid
  PartTree(const Mesh& mesh, const cnc::surface::Profile& profile);

  /// Returns the numbers of the facets in the order of the tree: the facets of a leaf are
  /// successive.
  [[nodiscard]] const std::vector<std::uint32_t>& order() const { return order_; }
  [[nodiscard]] const Node& node(std::uint32_t number) const { return nodes_[number]; }
  /// Returns, for each part of a node, an upper bound of the tip's height at which the tool touches
  /// the part; -infinity if the tool does not reach the part.
  [[nodiscard]] Lanes bounds(const Node& node, const Eigen::Vector2d& place) const;

 private:
  /// A range of consecutive entries of order().
  struct Run {
    std::uint32_t first, count;
  };
  class Builder;

  std::vector<std::uint32_t> order_;
  std::vector<Node> nodes_;  ///< Nodes of the tree; the first is the root.
  Shape tool_;
};

}  // namespace sim::surface
