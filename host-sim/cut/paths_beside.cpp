#include "host-sim/cut/paths_beside.hpp"

#include <memory>
#include <utility>

#include "host-sim/contour/contour_offset.hpp"
#include "host-sim/contour/shared_work.hpp"
#include "host-sim/cut/crowd.hpp"
#include "host-sim/cut/middles.hpp"

namespace sim::cut {
namespace {

using Rows = std::vector<std::vector<Stroke>>;

/// Returns the paths beside one outline, as if there were no other one.
PathBeside path_beside(const DrawnEdges& edges, std::size_t contour, ContourOffset& offset) {
  const std::vector<Stroke>& outline = edges.outlines[contour].strokes;
  const double half_kerf_mm = edges.half_kerf_mm(contour);
  const Contour drawn = contour_of(outline);
  PathBeside path{.loops = {outline}};
  try {
    if (half_kerf_mm > 0.0) path.loops = loops_of(offset.offset(drawn.view(), half_kerf_mm));
  } catch (const NoOffset& failure) {
    return {.failure = drawing::Fault{drawing::FaultKind::kTooMuch,
                                      edges.drawn.contours[contour].entity,
                                      failure.place(),
                                      failure.reason(),
                                      failure.remedy()}};
  }
  Middles middles = middles_beside(edges, {contour});
  path.vanishes = path.loops.empty() && middles.rows.empty();
  if (path.vanishes) return path;
  Rows driven = path.loops;
  driven.insert(driven.end(), middles.rows.begin(), middles.rows.end());
  path.rests = rests_along(outline, driven, half_kerf_mm, edges.reach_mm);
  path.middles = std::move(middles.rows);
  path.narrow = std::move(middles.warning);
  for (const std::vector<Stroke>& loop : path.loops) {
    if (auto gouge = gouge_of(edges.drawn, contour, loop, edges.near, half_kerf_mm)) {
      path.gouges.push_back(std::move(*gouge));
    }
  }
  return path;
}

void part_crowds(const DrawnEdges& edges,
                 std::vector<PathBeside>& paths,
                 std::vector<drawing::Fault>& warnings) {
  ContourOffset offset;
  for (const auto& crowd : crowds_of(edges.outlines, paths, edges.near, edges.half_kerf_mm)) {
    const std::vector<drawing::Fault> held = held_together(edges.drawn, crowd, paths);
    const double half_kerf_mm = edges.half_kerf_mm(crowd.front());
    const Middles middles = middles_beside(edges, crowd);
    if (!part_crowd(edges.outlines, crowd, half_kerf_mm, middles.rows, offset, paths)) continue;
    if (middles.warning) {
      warnings.push_back(*middles.warning);
    } else {
      warnings.insert(warnings.end(), held.begin(), held.end());
    }
  }
}

/// Parts that lie against each other are reported once, in place of each gouge.
void name_touching(const DrawnEdges& edges, std::vector<PathBeside>& paths) {
  for (std::size_t i = 0; i < paths.size(); ++i) {
    if (paths[i].gouges.empty()) continue;
    auto touch = touch_of(edges.drawn, i, edges.outlines, edges.near, edges.half_kerf_mm(i));
    if (touch) paths[i].gouges = {std::move(*touch)};
  }
}

}  // namespace

std::vector<PathBeside> paths_beside(const DrawnEdges& edges,
                                     std::vector<drawing::Fault>& warnings) {
  std::vector<PathBeside> paths(edges.outlines.size());
  share_work(paths.size(), [&] {
    return [&, offset = std::make_unique<ContourOffset>()](std::size_t i) {
      if (edges.outlines[i].is_beside) paths[i] = path_beside(edges, i, *offset);
    };
  });
  part_crowds(edges, paths, warnings);
  for (const PathBeside& path : paths) {
    if (path.narrow) warnings.push_back(*path.narrow);
  }
  name_touching(edges, paths);
  return paths;
}

}  // namespace sim::cut
