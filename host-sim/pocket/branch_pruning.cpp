#include "host-sim/pocket/branch_pruning.hpp"

#include <algorithm>
#include <cstddef>
#include <limits>
#include <queue>
#include <utility>
#include <vector>

namespace sim::pocket {
namespace {

constexpr std::uint32_t kNoNode = std::numeric_limits<std::uint32_t>::max();

/// Removes short branches, one at a time.
class BranchPruner {
 public:
  BranchPruner(AxisGraph& graph, double slack_mm)
      : graph_{graph},
        slack_mm_{slack_mm},
        degrees_(graph.nodes.size()),
        firsts_(graph.nodes.size() + 1),
        excess_(graph.nodes.size()),
        gone_(graph.edges.size()),
        dropped_(graph.nodes.size()) {
    for (const AxisEdge& edge : graph.edges) {
      ++degrees_[edge.from];
      ++degrees_[edge.to];
    }
    for (std::size_t i = 0; i < degrees_.size(); ++i) firsts_[i + 1] = firsts_[i] + degrees_[i];
    ends_.resize(firsts_.back());
    std::vector<std::uint32_t> filled{firsts_.begin(), firsts_.end() - 1};
    for (std::uint32_t i = 0; i < graph.edges.size(); ++i) {
      ends_[filled[graph.edges[i].from]++] = i;
      ends_[filled[graph.edges[i].to]++] = i;
    }
  }

  void prune() {
    const auto is_wider = [this](std::uint32_t a, std::uint32_t b) {
      return graph_.nodes[a].radius > graph_.nodes[b].radius;
    };
    // The narrowest leaf comes first. Therefore the last node of a part that shrinks to a point is
    // its widest node.
    std::priority_queue<std::uint32_t, std::vector<std::uint32_t>, decltype(is_wider)> leaves{
        is_wider};
    for (std::uint32_t i = 0; i < degrees_.size(); ++i) {
      if (degrees_[i] == 1) leaves.push(i);
      if (degrees_[i] == 0) dropped_[i] = true;  // The node has no edge in the area.
    }
    while (!leaves.empty()) {
      const std::uint32_t leaf = leaves.top();
      leaves.pop();
      const std::uint32_t end = prune_from(leaf);
      if (end != kNoNode && degrees_[end] == 1) leaves.push(end);
    }
    compact();
  }

 private:
  [[nodiscard]] std::uint32_t other_end(std::uint32_t edge, std::uint32_t node) const {
    const AxisEdge& here = graph_.edges[edge];
    return here.from == node ? here.to : here.from;
  }

  /// Returns a remaining edge at a node, except the edge `except`.
  [[nodiscard]] std::uint32_t edge_at(std::uint32_t node, std::uint32_t except) const {
    for (std::uint32_t i = firsts_[node]; i < firsts_[node + 1]; ++i) {
      if (!gone_[ends_[i]] && ends_[i] != except) return ends_[i];
    }
    return kNoNode;
  }

  /// Removes edges from `leaf` on, as long as the removed discs reach beyond the remaining discs by
  /// at most the slack. Returns the node at which the removed part ended.
  std::uint32_t prune_from(std::uint32_t leaf) {
    if (degrees_[leaf] != 1) return kNoNode;
    path_.clear();
    // Number of false edges (edges that are not real) at the beginning of the path.
    std::size_t false_edges = 0;
    std::uint32_t real_from = leaf;
    double excess = excess_[leaf];
    double widest = graph_.nodes[leaf].radius;
    std::uint32_t node = leaf;
    std::uint32_t edge = kNoNode;
    do {
      edge = edge_at(node, edge);
      const std::uint32_t to = other_end(edge, node);
      const bool is_real = graph_.edges[edge].is_real;
      if (is_real) excess += reach_beyond(node, to);
      excess = std::max(excess, excess_[to]);
      widest = std::max(widest, graph_.nodes[to].radius);
      // If the radius falls along a false edge, the path has passed the middle of a circle and
      // would follow the branch to another joint.
      const bool narrows = graph_.nodes[to].radius < widest - slack_mm_;
      if (excess > slack_mm_ || (!is_real && narrows)) {
        path_.resize(false_edges);
        node = real_from;
        excess = excess_[node];
        break;
      }
      path_.push_back(edge);
      node = to;
      if (is_real || false_edges + 1 != path_.size()) continue;
      ++false_edges;
      real_from = to;
    } while (degrees_[node] == 2);
    if (path_.empty()) return kNoNode;
    excess_[node] = std::max(excess_[node], excess);
    remove_path(leaf);
    return node;
  }

  /// Returns the distance by which the disc of `node` reaches beyond the disc of `to`, mm.
  [[nodiscard]] double reach_beyond(std::uint32_t node, std::uint32_t to) const {
    const AxisPoint& a = graph_.nodes[node];
    const AxisPoint& b = graph_.nodes[to];
    return (a.place - b.place).norm() + a.radius - b.radius;
  }

  void remove_path(std::uint32_t leaf) {
    std::uint32_t node = leaf;
    for (const std::uint32_t edge : path_) {
      gone_[edge] = true;
      dropped_[node] = true;
      --degrees_[node];
      node = other_end(edge, node);
      --degrees_[node];
    }
  }

  void compact() {
    std::vector<std::uint32_t> renumbered(graph_.nodes.size(), kNoNode);
    std::vector<AxisPoint> nodes;
    for (std::uint32_t i = 0; i < renumbered.size(); ++i) {
      if (dropped_[i]) continue;
      renumbered[i] = static_cast<std::uint32_t>(nodes.size());
      nodes.push_back(graph_.nodes[i]);
    }
    std::vector<AxisEdge> edges;
    for (std::uint32_t i = 0; i < graph_.edges.size(); ++i) {
      if (gone_[i]) continue;
      AxisEdge edge = graph_.edges[i];
      edge.from = renumbered[edge.from];
      edge.to = renumbered[edge.to];
      edges.push_back(edge);
    }
    graph_.nodes = std::move(nodes);
    graph_.edges = std::move(edges);
  }

  AxisGraph& graph_;
  double slack_mm_;
  std::vector<std::uint32_t> degrees_;
  std::vector<std::uint32_t> firsts_;  ///< For each node, the index of its first edge in `ends_`.
  std::vector<std::uint32_t> ends_;
  /// For each node, the distance by which the removed branches reach beyond its disc, mm.
  std::vector<double> excess_;
  std::vector<bool> gone_;
  std::vector<bool> dropped_;
  std::vector<std::uint32_t> path_;
};

}  // namespace

void prune_branches(AxisGraph& graph, double slack_mm) { BranchPruner{graph, slack_mm}.prune(); }

}  // namespace sim::pocket
