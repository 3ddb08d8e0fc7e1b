#include "host-sim/surface/path/iso_lines.hpp"

#include <algorithm>
#include <array>
#include <unordered_map>
#include <unordered_set>

namespace sim::surface {
namespace {

/// Number of an edge of the grid: twice the number of its first node, plus 1 if the edge is along
/// Y.
using Edge = std::size_t;

/// Collects the steps of lines from edge to edge, and joins the steps to lines.
class LineFinder {
 public:
  LineFinder(const PlanGrid& grid,
             const std::function<NodeSide(std::size_t)>& side_of,
             const std::function<bool(std::size_t)>& has_high_middle)
      : grid_{grid}, has_high_middle_{has_high_middle}, sides_(grid.size()) {
    for (std::size_t node = 0; node < grid.size(); ++node) sides_[node] = side_of(node);
  }

  std::vector<IsoLine> run() {
    for (std::size_t row = 0; row + 1 < grid_.rows(); ++row) {
      for (std::size_t column = 0; column + 1 < grid_.columns(); ++column) {
        step_through(grid_.node(column, row));
      }
    }
    std::vector<IsoLine> lines;
    for (const Edge start : open_starts()) lines.push_back(line_from(start));
    while (!next_.empty()) lines.push_back(line_from(first_left()));
    return lines;
  }

 private:
  /// Corners or edges of a cell, counter-clockwise. Edge i connects corner i to the next corner.
  using Corners = std::array<std::size_t, 4>;

  [[nodiscard]] Corners corners_of(std::size_t node) const {
    return {node, node + 1, node + grid_.columns() + 1, node + grid_.columns()};
  }

  [[nodiscard]] Edge edge_of(std::size_t node, std::size_t number) const {
    const std::array<Edge, 4> edges{
        2 * node, 2 * (node + 1) + 1, 2 * (node + grid_.columns()), 2 * node + 1};
    return edges[number];
  }

  /// Adds the steps of lines within the cell of `node`. A line enters the cell at an edge whose
  /// corners, in counter-clockwise order, change from low to high. The high corners are thus on the
  /// right.
  void step_through(std::size_t node) {
    const Corners corners = corners_of(node);
    const auto side = [&](std::size_t i) { return sides_[corners[i % 4]]; };
    std::size_t highs = 0;
    for (std::size_t i = 0; i < 4; ++i) {
      if (side(i) == NodeSide::kNone) return;
      if (side(i) == NodeSide::kHigh) ++highs;
    }
    if (highs == 0 || highs == 4) return;
    const bool alternates = highs == 2 && side(0) == side(2);
    const bool joins_highs = alternates && has_high_middle_(node);
    for (std::size_t i = 0; i < 4; ++i) {
      if (side(i) != NodeSide::kHigh || side(i + 3) != NodeSide::kLow) continue;
      // The line goes around the successive high corners from corner i on. If high and low corners
      // alternate and the cell is high in its middle, the line goes around the preceding low corner
      // instead.
      std::size_t last = i;
      while (side(last + 1) == NodeSide::kHigh) ++last;
      if (joins_highs) last = i + 2;
      add_step(edge_of(node, (i + 3) % 4), edge_of(node, last % 4));
    }
  }

  void add_step(Edge from, Edge to) {
    next_.emplace(from, to);
    order_.push_back(from);
  }

  /// Returns the edges at which open lines begin, in the order of the grid.
  [[nodiscard]] std::vector<Edge> open_starts() const {
    std::unordered_set<Edge> reached;
    for (const auto& [from, to] : next_) reached.insert(to);
    std::vector<Edge> starts;
    std::ranges::copy_if(order_, std::back_inserter(starts), [&reached](Edge edge) {
      return !reached.contains(edge);
    });
    return starts;
  }

  /// Returns the first edge, in the order of the grid, whose step is not yet part of a line.
  Edge first_left() {
    while (!next_.contains(order_[taken_])) ++taken_;
    return order_[taken_];
  }

  IsoLine line_from(Edge start) {
    IsoLine line;
    line.edges.push_back(crossed(start));
    auto found = next_.find(start);
    while (found != next_.end()) {
      const Edge edge = found->second;
      next_.erase(found);
      line.is_closed = edge == start;
      if (!line.is_closed) line.edges.push_back(crossed(edge));
      found = next_.find(edge);
    }
    return line;
  }

  [[nodiscard]] CrossedEdge crossed(Edge edge) const {
    const std::size_t first = edge / 2;
    const std::size_t second = edge % 2 == 0 ? first + 1 : first + grid_.columns();
    return sides_[first] == NodeSide::kHigh ? CrossedEdge{second, first}
                                            : CrossedEdge{first, second};
  }

  const PlanGrid& grid_;
  const std::function<bool(std::size_t)>& has_high_middle_;
  std::vector<NodeSide> sides_;
  std::unordered_map<Edge, Edge> next_;
  std::vector<Edge> order_;
  std::size_t taken_ = 0;
};

}  // namespace

std::vector<IsoLine> iso_lines(const PlanGrid& grid,
                               const std::function<NodeSide(std::size_t)>& side_of,
                               const std::function<bool(std::size_t)>& has_high_middle) {
  return LineFinder{grid, side_of, has_high_middle}.run();
}

}  // namespace sim::surface
