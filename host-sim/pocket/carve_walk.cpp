#include "host-sim/pocket/carve_walk.hpp"

#include <algorithm>
#include <limits>
#include <optional>
#include <queue>
#include <tuple>
#include <unordered_map>

namespace sim::pocket {
namespace {

double length_of(const CarvePiece& piece) {
  double length = 0.0;
  for (std::size_t i = 1; i < piece.points.size(); ++i) {
    length += (piece.points[i].place - piece.points[i - 1].place).norm();
  }
  return length;
}

class CarveWalker {
 public:
  CarveWalker(const CarveGraph& graph, double return_limit_mm)
      : graph_{graph},
        return_limit_mm_{return_limit_mm},
        at_node_(graph.nodes.size()),
        left_(graph.nodes.size()),
        is_cut_(graph.pieces.size()) {
    for (std::size_t i = 0; i < graph.pieces.size(); ++i) {
      const CarvePiece& piece = graph.pieces[i];
      lengths_.push_back(length_of(piece));
      at_node_[piece.from].push_back(i);
      if (piece.to != piece.from) at_node_[piece.to].push_back(i);
      ++left_[piece.from];
      ++left_[piece.to];
    }
  }

  std::vector<WalkStep> walk() {
    std::size_t cut = 0;
    bool lifted = true;
    while (cut < graph_.pieces.size()) {
      if (left_[node_] == 0 || cut == 0) {
        lifted = cut == 0 || !return_to_work();
        if (lifted) node_ = nearest_start(cut == 0);
      }
      while (left_[node_] > 0) {
        const std::size_t piece = next_piece();
        is_cut_[piece] = true;
        --left_[graph_.pieces[piece].from];
        --left_[graph_.pieces[piece].to];
        ++cut;
        drive(piece, false, lifted);
        lifted = false;
      }
    }
    return std::move(steps_);
  }

 private:
  void drive(std::size_t piece, bool is_return, bool begins_row) {
    const CarvePiece& here = graph_.pieces[piece];
    const bool is_reversed = here.from != node_;
    steps_.push_back({piece, is_reversed, is_return, begins_row});
    node_ = is_reversed ? here.from : here.to;
  }

  /// Returns the best piece to cut from the current node: short dead ends first, then pieces that
  /// continue, then long dead ends.
  [[nodiscard]] std::size_t next_piece() const {
    std::optional<std::size_t> best;
    std::tuple<int, double> least{};
    for (const std::size_t piece : at_node_[node_]) {
      if (is_cut_[piece]) continue;
      const CarvePiece& here = graph_.pieces[piece];
      const std::uint32_t other = here.from == node_ ? here.to : here.from;
      const bool is_dead_end = other != node_ && left_[other] == 1;
      const bool is_short = lengths_[piece] <= return_limit_mm_;
      const std::tuple<int, double> rank{is_dead_end ? (is_short ? 0 : 2) : 1, lengths_[piece]};
      if (best && rank >= least) continue;
      best = piece;
      least = rank;
    }
    return *best;
  }

  /// Drives along cut pieces to the nearest node with uncut pieces. Returns false if no such node
  /// is within the limit of returns.
  bool return_to_work() {
    using Reached = std::pair<double, std::uint32_t>;
    std::priority_queue<Reached, std::vector<Reached>, std::greater<>> reached;
    // For each reached node, the length of the path to it, and the last piece of this path.
    std::unordered_map<std::uint32_t, std::pair<double, std::size_t>> ways;
    reached.push({0.0, node_});
    ways[node_] = {0.0, 0};
    while (!reached.empty()) {
      const auto [length, node] = reached.top();
      reached.pop();
      if (length > ways[node].first) continue;
      if (left_[node] > 0) {
        drive_back(node, ways);
        return true;
      }
      for (const std::size_t piece : at_node_[node]) {
        const CarvePiece& here = graph_.pieces[piece];
        const std::uint32_t to = here.from == node ? here.to : here.from;
        const double way = length + lengths_[piece];
        if (!is_cut_[piece] || way > return_limit_mm_) continue;
        const auto found = ways.find(to);
        if (found != ways.end() && found->second.first <= way) continue;
        ways[to] = {way, piece};
        reached.push({way, to});
      }
    }
    return false;
  }

  void drive_back(std::uint32_t to,
                  const std::unordered_map<std::uint32_t, std::pair<double, std::size_t>>& ways) {
    std::vector<std::size_t> pieces;
    for (std::uint32_t node = to; node != node_;) {
      const std::size_t piece = ways.at(node).second;
      pieces.push_back(piece);
      const CarvePiece& here = graph_.pieces[piece];
      node = here.from == node ? here.to : here.from;
    }
    std::ranges::reverse(pieces);
    for (const std::size_t piece : pieces) drive(piece, true, false);
  }

  [[nodiscard]] std::uint32_t nearest_start(bool is_first) const {
    std::uint32_t best = 0;
    std::tuple<bool, double> least{true, std::numeric_limits<double>::infinity()};
    for (std::uint32_t i = 0; i < left_.size(); ++i) {
      if (left_[i] == 0) continue;
      const double away =
          is_first ? 0.0 : (graph_.nodes[i].place - graph_.nodes[node_].place).norm();
      const std::tuple<bool, double> rank{left_[i] % 2 == 0, away + graph_.nodes[i].radius};
      if (rank >= least) continue;
      best = i;
      least = rank;
    }
    return best;
  }

  const CarveGraph& graph_;
  double return_limit_mm_;
  std::vector<std::vector<std::size_t>> at_node_;
  /// For each node, the number of ends of uncut pieces at the node.
  std::vector<std::uint32_t> left_;
  std::vector<bool> is_cut_;
  std::vector<double> lengths_;
  std::vector<WalkStep> steps_;
  std::uint32_t node_ = 0;
};

}  // namespace

std::vector<WalkStep> walk_along(const CarveGraph& graph, double return_limit_mm) {
  if (graph.pieces.empty()) return {};
  return CarveWalker{graph, return_limit_mm}.walk();
}

}  // namespace sim::pocket
