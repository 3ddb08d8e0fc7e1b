#include "host-sim/pocket/axis_graph.hpp"

#include <algorithm>
#include <boost/polygon/voronoi_builder.hpp>
#include <boost/polygon/voronoi_diagram.hpp>
#include <cstddef>
#include <utility>

#include "host-sim/pocket/chord_rows.hpp"
#include "host-sim/pocket/smooth_rows.hpp"

namespace sim::pocket {
namespace {

using Diagram = boost::polygon::voronoi_diagram<double>;

/// Builds the diagram into `diagram`, because a diagram cannot be moved.
void construct(const ChordRows& rows, Diagram& diagram) {
  boost::polygon::voronoi_builder<std::int32_t> builder;
  for (const Chord& chord : rows.chords) {
    builder.insert_segment(chord.from.x, chord.from.y, chord.to.x, chord.to.y);
  }
  builder.construct(&diagram);
}

/// Copies the vertices and edges of a diagram that are in the area.
class GraphReader {
 public:
  GraphReader(const OwnedArea& area,
              const ChordRows& rows,
              const Diagram& diagram,
              double sagitta_mm)
      : area_{area},
        rows_{rows},
        diagram_{diagram},
        touch_mm_{2.0 * sagitta_mm + 4.0 * rows.unit_mm},
        smooth_{*area} {}

  AxisGraph read() {
    for (const auto& vertex : diagram_.vertices()) read_vertex(vertex);
    for (const auto& edge : diagram_.edges()) {
      if (&edge < edge.twin() && edge.is_primary() && edge.is_finite()) read_edge(edge);
    }
    return std::move(graph_);
  }

 private:
  void read_vertex(const Diagram::vertex_type& vertex) {
    const cnc::WideVec2 place = rows_.place(vertex.x(), vertex.y());
    const cnc::pocket::BoundaryPoint nearest = area_->nearest(place);
    // Corners of the area, and corners between tangents, are vertices of the diagram, with a small
    // error by the grid.
    const bool is_corner = nearest.distance <= (nearest.inside ? 4.0 * rows_.unit_mm : touch_mm_);
    const double depth = nearest.inside ? nearest.distance : -nearest.distance;
    graph_.nodes.push_back(is_corner ? AxisPoint{nearest.point, 0.0} : AxisPoint{place, depth});
  }

  void read_edge(const Diagram::edge_type& edge) {
    const auto index_of = [&](const Diagram::vertex_type* vertex) {
      return static_cast<std::uint32_t>(vertex - diagram_.vertices().data());
    };
    const std::uint32_t from = index_of(edge.vertex0());
    const std::uint32_t to = index_of(edge.vertex1());
    const double least = std::min(graph_.nodes[from].radius, graph_.nodes[to].radius);
    const double most = std::max(graph_.nodes[from].radius, graph_.nodes[to].radius);
    if (least < 0.0 || most <= 0.0) return;
    BoundarySite left = site_of(*edge.cell());
    BoundarySite right = site_of(*edge.twin()->cell());
    const bool is_real = smooth_.may_share_disc(left, right);
    // The graph stores one element for each of the two sites of an edge. A corner has two elements:
    // the graph stores the element that the other site does not have.
    if (right.has(left.element)) std::swap(left.element, left.other);
    if (left.has(right.element)) std::swap(right.element, right.other);
    graph_.edges.push_back({from, to, left.element, right.element, is_real});
  }

  [[nodiscard]] BoundarySite site_of(const Diagram::cell_type& cell) const {
    const std::size_t index = cell.source_index();
    const std::uint32_t element = rows_.chords[index].element;
    if (cell.source_category() == boost::polygon::SOURCE_CATEGORY_SEGMENT_START_POINT) {
      const bool is_first = index == 0 || rows_.chords[index - 1].element != element;
      if (is_first && !smooth_.begins_smoothly(element)) return {element, area_->previous(element)};
    }
    if (cell.source_category() == boost::polygon::SOURCE_CATEGORY_SEGMENT_END_POINT) {
      const bool is_last =
          index + 1 == rows_.chords.size() || rows_.chords[index + 1].element != element;
      const std::uint32_t next = area_->next(element);
      if (is_last && !smooth_.begins_smoothly(next)) return {element, next};
    }
    return {element, element};
  }

  const OwnedArea& area_;
  const ChordRows& rows_;
  const Diagram& diagram_;
  /// Greatest distance of a computed corner of the area from the area, mm.
  double touch_mm_;
  SmoothRows smooth_;
  AxisGraph graph_;
};

}  // namespace

AxisGraph voronoi_graph(const OwnedArea& area, double sagitta_mm) {
  if (area->element_count() == 0) return {};
  const ChordRows rows = chords_of(*area, sagitta_mm);
  Diagram diagram;
  construct(rows, diagram);
  return GraphReader{area, rows, diagram, sagitta_mm}.read();
}

}  // namespace sim::pocket
