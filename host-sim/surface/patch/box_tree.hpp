#pragma once

#include <Eigen/Geometry>
#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace sim::surface::patch {

/// Boxes sorted into a tree, for searches of the items nearest to a point.
class BoxTree {
 public:
  /// Halvings that leave one item of 2^32.
  static constexpr std::size_t kMaxDepth = 33;

  BoxTree() = default;
  explicit BoxTree(const std::vector<Eigen::AlignedBox3d>& boxes);

  /// Calls `visit(item)` for all items whose box is nearer to the point than `bound()`, which may
  /// shrink meanwhile and ends the search once negative; near parts of the tree come first.
  template <typename Bound, typename Visit>
  void visit_near(const Eigen::Vector3d& point, const Bound& bound, const Visit& visit) const {
    if (nodes_.empty()) return;
    struct Open {
      std::uint32_t node;
      double square;
    };
    std::array<Open, kMaxDepth + 1> open{};
    std::size_t count = 0;
    open[count++] = {0, nodes_[0].box.squaredExteriorDistance(point)};
    while (count > 0) {
      const Open next = open[--count];
      const double most = bound();
      if (most < 0.0) return;
      if (next.square > most * most) continue;
      const Node& node = nodes_[next.node];
      if (node.item_count > 0) {
        for (std::uint32_t i = 0; i < node.item_count; ++i) visit(items_[node.first + i]);
        continue;
      }
      std::array<Open, 2> halves{Open{node.first, 0.0}, Open{node.first + 1, 0.0}};
      for (Open& half : halves) half.square = nodes_[half.node].box.squaredExteriorDistance(point);
      if (halves[0].square < halves[1].square) std::swap(halves[0], halves[1]);
      open[count++] = halves[0];
      open[count++] = halves[1];
    }
  }

 private:
  struct Node {
    Eigen::AlignedBox3d box;
    std::uint32_t first = 0;       ///< The first of two nodes, or an index of items_.
    std::uint32_t item_count = 0;  ///< 0 unless the node is a leaf.
  };

  std::vector<Node> nodes_;  ///< The first is the root.
  std::vector<std::uint32_t> items_;
};

}  // namespace sim::surface::patch
