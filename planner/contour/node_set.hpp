#pragma once

#include <algorithm>

#include "planner/contour/offset_space.hpp"

namespace cnc::contour {

/// Set of nodes. It records which nodes stand for the same point.
template <typename Scalar>
class NodeSet {
 public:
  NodeSet(Slice<Node<Scalar>> nodes, std::uint32_t count) : nodes_{nodes}, count_{count} {}

  [[nodiscard]] std::uint32_t count() const { return count_; }

  /// Adds a node at `place` and returns its number. @pre the storage has free space
  std::uint32_t add(const BasicVec2<Scalar>& place) {
    nodes_[count_] = {place, count_};
    return count_++;
  }

  /// Returns the node that represents all nodes at the same point. Shortens the chain of references
  /// to that node.
  [[nodiscard]] std::uint32_t find(std::uint32_t node) {
    while (nodes_[node].same_as != node) {
      nodes_[node].same_as = nodes_[nodes_[node].same_as].same_as;
      node = nodes_[node].same_as;
    }
    return node;
  }

  /// Declares that two nodes are the same point. The node with the smaller number keeps its point.
  /// Ends of raw curves have the smallest numbers, so they keep their points.
  void unite(std::uint32_t a, std::uint32_t b) {
    a = find(a);
    b = find(b);
    nodes_[std::max(a, b)].same_as = std::min(a, b);
  }

  [[nodiscard]] const BasicVec2<Scalar>& place(std::uint32_t node) const {
    return nodes_[node].place;
  }

 private:
  Slice<Node<Scalar>> nodes_;
  std::uint32_t count_;
};

}  // namespace cnc::contour
