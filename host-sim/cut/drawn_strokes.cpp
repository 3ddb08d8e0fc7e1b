#include "host-sim/cut/drawn_strokes.hpp"

#include <utility>

#include "host-sim/contour/known_rows.hpp"

namespace sim::cut {

DrawnStrokes strokes_of(const drawing::DrawnContour& contour, const OutlineOptions& curves) {
  KnownRows known;
  return strokes_of(contour, curves, known);
}

DrawnStrokes strokes_of(const drawing::DrawnContour& contour,
                        const OutlineOptions& curves,
                        KnownRows& known) {
  FittedContour fitted = arcs_of(contour, curves, known);
  if (fitted.fault) return {{}, std::move(fitted.fault)};
  const std::vector<ContourVertex>& vertices = fitted.vertices;
  DrawnStrokes drawn;
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    const std::size_t next = i + 1 < vertices.size() ? i + 1 : 0;
    if (next == 0 && !contour.closed) break;
    drawn.strokes.push_back({vertices[i].point(), vertices[next].point(), vertices[i].bulge});
  }
  return drawn;
}

}  // namespace sim::cut
