#pragma once

#include <Eigen/Geometry>
#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace sim::surface {

/// A tree of bounding boxes. It finds the items near a point, or the items whose value is below a
/// bound.
class BoxTree {
 public:
  /// Maximum depth of the tree: 2^32 items are halved 32 times until one item is left.
  static constexpr std::size_t kMaxDepth = 33;

  BoxTree() = default;
  explicit BoxTree(const std::vector<Eigen::AlignedBox3d>& boxes);

  /// Calls `visit(item)` for all items whose box is at most `bound()` away from the point. The
  /// bound may shrink during the search, and a negative bound ends the search. The nearer part of
  /// the tree is searched first.
  template <typename Bound, typename Visit>
  void visit_near(const Eigen::Vector3d& point, const Bound& bound, const Visit& visit) const {
    visit_least(
        [&point](const Eigen::AlignedBox3d& box) { return box.squaredExteriorDistance(point); },
        [&bound] {
          const double most = bound();
          return most < 0.0 ? -1.0 : most * most;
        },
        visit);
  }

  /// Calls `visit(item)` for all items with `value(box)` <= `most()`. The limit `most()` may shrink
  /// during the search. The part of the tree with the smaller value is searched first.
  template <typename Value, typename Most, typename Visit>
  void visit_least(const Value& value, const Most& most, const Visit& visit) const {
    if (nodes_.empty()) return;
    struct Open {
      std::uint32_t node;
      double value;
    };
    std::array<Open, kMaxDepth + 1> open{};
    std::size_t count = 0;
    open[count++] = {0, value(nodes_[0].box)};
    while (count > 0) {
      const Open next = open[--count];
      if (next.value > most()) continue;
      const Node& node = nodes_[next.node];
      if (node.item_count > 0) {
        for (std::uint32_t i = 0; i < node.item_count; ++i) visit(items_[node.first + i]);
        continue;
      }
      std::array<Open, 2> halves{Open{node.first, 0.0}, Open{node.first + 1, 0.0}};
      for (Open& half : halves) half.value = value(nodes_[half.node].box);
      if (halves[0].value < halves[1].value) std::swap(halves[0], halves[1]);
      open[count++] = halves[0];
      open[count++] = halves[1];
    }
  }

 private:
  struct Node {
    Eigen::AlignedBox3d box;
    /// Index of the first of two successive child nodes; in a leaf, index of its first item in
    /// items_.
    std::uint32_t first = 0;
    std::uint32_t item_count = 0;  ///< Number of items in a leaf; 0 for other nodes.
  };

  std::vector<Node> nodes_;  ///< Nodes of the tree; the first is the root.
  std::vector<std::uint32_t> items_;
};

}  // namespace sim::surface
