#include "host-sim/pocket/medial_axis.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

#include "host-sim/pocket/branch_pruning.hpp"
#include "planner/pocket/nearest_point.hpp"

namespace sim::pocket {
namespace {

using cnc::WideVec2;
using cnc::pocket::nearest_point_of;

constexpr double kSagittaShare = 0.1;  ///< Sagitta of chords, as a share of the tolerance.

/// Inserts points between neighbouring points of a chain until straight lines between them are
/// within the tolerance.
class ChainRefiner {
 public:
  ChainRefiner(const OwnedArea& area, double tolerance_mm)
      : area_{area}, tolerance_mm_{tolerance_mm} {}

  /// Returns whether an edge is outside of the area, although both its nodes count as inside. At
  /// the boundary point nearest to such a node, hair-thin parts of the boundary meet. There, the
  /// test on which side of the boundary the node is may fail.
  [[nodiscard]] bool is_outside(const AxisPoint& from,
                                const AxisPoint& to,
                                const AxisEdge& edge) const {
    return area_->depth(middle_place(from, to, edge)) < -tolerance_mm_;
  }

  /// Appends `to`, and before it the points that the tolerance requires between the last point and
  /// `to`.
  void append(std::vector<AxisPoint>& points, const AxisPoint& to, const AxisEdge& edge) {
    // Points that are still to be appended, in reverse order. `depth` counts the halvings of the
    // stretch before `point`.
    struct Pending {
      AxisPoint point;
      int depth;
    };
    std::vector<Pending> pending{{to, 0}};
    while (!pending.empty()) {
      const AxisPoint from = points.back();
      Pending& next = pending.back();
      const AxisPoint middle = middle_of(from, next.point, edge);
      if (next.depth < kMaxHalvings && is_apart(from, middle, next.point)) {
        ++next.depth;
        pending.push_back({middle, next.depth});
        continue;
      }
      points.push_back(next.point);
      pending.pop_back();
    }
  }

 private:
  static constexpr int kMaxHalvings = 12;

  [[nodiscard]] bool is_apart(const AxisPoint& from,
                              const AxisPoint& middle,
                              const AxisPoint& to) const {
    const WideVec2 mean = 0.5 * (from.place + to.place);
    return (middle.place - mean).norm() > tolerance_mm_ ||
           std::abs(middle.radius - 0.5 * (from.radius + to.radius)) > tolerance_mm_;
  }

  [[nodiscard]] AxisPoint middle_of(const AxisPoint& from,
                                    const AxisPoint& to,
                                    const AxisEdge& edge) const {
    const WideVec2 place = middle_place(from, to, edge);
    return {place, std::max(0.0, area_->depth(place))};
  }

  /// Returns a point near the middle of two points. It has the same distance from both elements of
  /// an edge.
  [[nodiscard]] WideVec2 middle_place(const AxisPoint& from,
                                      const AxisPoint& to,
                                      const AxisEdge& edge) const {
    constexpr int kSteps = 8;
    const WideVec2 middle = 0.5 * (from.place + to.place);
    const double reach = 0.5 * (to.place - from.place).norm();
    WideVec2 place = middle;
    for (int i = 0; i < kSteps; ++i) {
      const WideVec2 left = place - nearest_point_of(area_->element(edge.left), place);
      const WideVec2 right = place - nearest_point_of(area_->element(edge.right), place);
      const double difference = left.norm() - right.norm();
      const WideVec2 gradient = left.normalized() - right.normalized();
      const double square = gradient.squaredNorm();
      if (std::abs(difference) <= kSagittaShare * tolerance_mm_ || square < kMinSquare) break;
      place -= (difference / square) * gradient;
    }
    return (place - middle).norm() <= reach ? place : middle;
  }

  /// Squared length of the difference between two unit vectors below which the vectors count as
  /// parallel.
  static constexpr double kMinSquare = 1.0e-8;

  const OwnedArea& area_;
  double tolerance_mm_;
};

/// Joins the edges of a graph to chains.
class ChainMaker {
 public:
  ChainMaker(const OwnedArea& area, const AxisGraph& graph, double tolerance_mm)
      : graph_{graph},
        refiner_{area, tolerance_mm},
        at_node_(graph.nodes.size()),
        numbers_(graph.nodes.size(), kNoNumber),
        used_(graph.edges.size()) {
    for (std::uint32_t i = 0; i < graph.edges.size(); ++i) {
      at_node_[graph.edges[i].from].push_back(i);
      at_node_[graph.edges[i].to].push_back(i);
    }
  }

  MedialAxis make() {
    for (std::uint32_t i = 0; i < at_node_.size(); ++i) {
      if (at_node_[i].size() != 2) begin_at(i);
    }
    // The remaining edges form loops without a branch or an end. In each loop, an arbitrary node
    // becomes a node of the axis.
    for (std::uint32_t i = 0; i < at_node_.size(); ++i) {
      if (at_node_[i].size() == 2 && !used_[at_node_[i].front()]) begin_at(i);
    }
    return std::move(axis_);
  }

 private:
  static constexpr std::uint32_t kNoNumber = 0xFFFFFFFF;

  std::uint32_t number_of(std::uint32_t node) {
    if (numbers_[node] == kNoNumber) {
      numbers_[node] = static_cast<std::uint32_t>(axis_.nodes.size());
      axis_.nodes.push_back(graph_.nodes[node]);
    }
    return numbers_[node];
  }

  void begin_at(std::uint32_t node) {
    number_of(node);
    for (const std::uint32_t edge : at_node_[node]) {
      if (!used_[edge]) follow(node, edge);
    }
  }

  void follow(std::uint32_t first, std::uint32_t edge) {
    AxisChain chain{.from = number_of(first), .points = {graph_.nodes[first]}};
    std::uint32_t node = first;
    for (;;) {
      used_[edge] = true;
      const AxisEdge& here = graph_.edges[edge];
      node = here.from == node ? here.to : here.from;
      refiner_.append(chain.points, graph_.nodes[node], here);
      if (node == first || at_node_[node].size() != 2) break;
      edge = at_node_[node][at_node_[node].front() == edge ? 1 : 0];
    }
    chain.to = number_of(node);
    axis_.chains.push_back(std::move(chain));
  }

  const AxisGraph& graph_;
  ChainRefiner refiner_;
  std::vector<std::vector<std::uint32_t>> at_node_;
  std::vector<std::uint32_t> numbers_;
  std::vector<bool> used_;
  MedialAxis axis_;
};

}  // namespace

MedialAxis medial_axis(const OwnedArea& area, const AxisOptions& options) {
  AxisGraph graph = voronoi_graph(area, kSagittaShare * options.tolerance_mm);
  const ChainRefiner refiner{area, options.tolerance_mm};
  std::erase_if(graph.edges, [&](const AxisEdge& edge) {
    return refiner.is_outside(graph.nodes[edge.from], graph.nodes[edge.to], edge);
  });
  prune_branches(graph, options.slack_mm);
  return ChainMaker{area, graph, options.tolerance_mm}.make();
}

}  // namespace sim::pocket
