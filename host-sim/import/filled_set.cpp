#include "host-sim/import/filled_set.hpp"

#include <algorithm>
#include <cmath>
#include <unordered_map>
#include <utility>

#include "host-sim/contour/contour_loops.hpp"
#include "host-sim/contour/simple_loops.hpp"
#include "planner/pocket/loop_measures.hpp"

namespace sim::drawing {
namespace {

bool is_inside(const Windings& windings, const std::vector<std::optional<FillingLoop>>& loops) {
  bool inside = false;
  std::vector<std::pair<std::uint32_t, int>> shapes;
  for (const LoopTurns& turns : windings) {
    const auto& loop = loops[turns.loop];
    if (!loop) continue;
    if (!loop->is_nonzero) {
      inside = inside != (turns.turns % 2 != 0);
      continue;
    }
    const auto known =
        std::ranges::find(shapes, loop->shape, [](const auto& shape) { return shape.first; });
    if (known == shapes.end()) {
      shapes.emplace_back(loop->shape, turns.turns);
    } else {
      known->second += turns.turns;
    }
  }
  for (const auto& [shape, turns] : shapes) inside = inside != (turns != 0);
  return inside;
}

double length_of_loop(const cnc::contour::ContourView<double>& view, std::size_t loop) {
  double length = 0.0;
  for (std::uint32_t i = view.loop_begin(loop); i < view.loop_ends[loop]; ++i) {
    length += cnc::pocket::length_of(cnc::pocket::element_at(view, loop, i));
  }
  return length;
}

/// Moves the loops that are large enough for a cut to `filled`, and counts the other loops in
/// FilledSet::small_loops.
void sort_out(const Contour& loops, const LeastLoop& least, FilledSet& filled) {
  const auto view = loops.view();
  for (std::size_t loop = 0; loop < view.loop_ends.size(); ++loop) {
    const double area = std::abs(cnc::pocket::signed_area(view, loop));
    const double width = 2.0 * area / std::max(length_of_loop(view, loop), 1.0e-9);
    if (area >= least.area_mm2 && width >= least.width_mm) {
      append_loop(view, loop, filled.outlines);
      continue;
    }
    ++filled.small_loops;
    filled.greatest_small.take_greater(area, view.vertices[view.loop_begin(loop)].point());
  }
}

/// Returns a point at which edges of a set cross, touch or separate.
Place crossing_of(const Arrangement& arrangement, std::span<const std::uint32_t> edges) {
  std::unordered_map<std::uint32_t, std::size_t> degrees;
  for (const std::uint32_t number : edges) {
    const ArrangedEdge& edge = arrangement.edges()[number];
    for (const std::uint32_t node : {edge.from_node, edge.to_node}) {
      if (++degrees[node] > 2) return arrangement.place(node);
    }
  }
  return arrangement.middle(arrangement.edges()[edges.front()]);
}

}  // namespace

std::optional<FilledSet> fill_set(Arrangement& arrangement,
                                  std::span<const std::uint32_t> edges,
                                  const std::vector<std::optional<FillingLoop>>& loops,
                                  const LeastLoop& least) {
  FilledSet filled;
  if (edges.empty()) return filled;
  filled.crossing = crossing_of(arrangement, edges);
  std::vector<DirectedEdge> kept;
  for (const std::uint32_t number : edges) {
    const ArrangedEdge& edge = arrangement.edges()[number];
    const bool left = is_inside(arrangement.windings(edge.left), loops);
    const bool right = is_inside(arrangement.windings(edge.right), loops);
    if (left != right) {
      kept.push_back({number, right});
      continue;
    }
    const double length = arrangement.length_mm(edge);
    filled.unseen_mm += length;
    filled.longest_unseen.take_greater(length, arrangement.middle(edge));
  }
  Contour written;
  if (!arrangement.write_loops(kept, written)) return std::nullopt;
  sort_out(simple_loops(written.view()), least, filled);
  return filled;
}

}  // namespace sim::drawing
