#include "host-sim/cut/path_beside.hpp"

#include <utility>

#include "host-sim/cut/kerf_faults.hpp"

namespace sim::cut {

PathBeside path_beside(const DrawnEdges& edges,
                       std::size_t contour,
                       double half_kerf_mm,
                       ContourOffset& offset) {
  const std::vector<Stroke>& outline = edges.outlines[contour].strokes;
  const drawing::Entity& entity = edges.drawn.contours[contour].entity;
  PathBeside path;
  const Contour drawn = contour_of(outline);
  path.loops = {outline};
  try {
    if (half_kerf_mm > 0.0) path.loops = loops_of(offset.offset(drawn.view(), half_kerf_mm));
  } catch (const NoOffset& failure) {
    path.failure = {
        drawing::FaultKind::kTooMuch, entity, failure.place(), failure.reason(), failure.remedy()};
  }
  if (path.failure || path.loops.empty()) return path;
  path.rests = rests_of(entity, outline, path.loops, half_kerf_mm, edges.reach_mm);
  for (const std::vector<Stroke>& loop : path.loops) {
    if (auto gouge = gouge_of(edges.drawn, contour, loop, edges.near, half_kerf_mm)) {
      path.gouges.push_back(std::move(*gouge));
    }
  }
  if (path.gouges.empty()) return path;
  auto touch = touch_of(edges.drawn, contour, edges.outlines, edges.near, half_kerf_mm);
  if (touch) path.gouges = {std::move(*touch)};
  return path;
}

}  // namespace sim::cut
