#include "host-sim/cut/paths_beside.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <optional>
#include <string>
#include <utility>

#include "host-sim/contour/contour_offset.hpp"
#include "host-sim/contour/shared_work.hpp"
#include "host-sim/cut/crowd.hpp"
#include "host-sim/cut/middles.hpp"

namespace sim::cut {
namespace {

using Rows = std::vector<std::vector<Stroke>>;

/// Returns the offset paths of one outline. Other outlines do not affect them.
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

/// Returns a warning for each outline that shares edges or points with others. The warning names a
/// shared point, and the width that the cut takes off there.
std::vector<drawing::Fault> shared_by(const DrawnEdges& edges,
                                      const std::vector<std::size_t>& crowd,
                                      const SharedEdges& shared) {
  std::vector<drawing::Fault> warnings;
  for (const std::size_t i : crowd) {
    const double half_kerf_mm = edges.half_kerf_mm(i);
    double shared_mm = 0.0;
    std::optional<Place> where;
    for (const SharedEdge& edge : shared.edges) {
      if (edge.beside[0].contour != i && edge.beside[1].contour != i) continue;
      const double length_mm = length_of(edge.strokes);
      if (!where || shared_mm == 0.0) {
        where = length_mm > 0.0 ? MeasuredRow{edge.strokes}.place(0.5 * length_mm)
                                : shared.nodes[edge.nodes[0]];
      }
      shared_mm += length_mm;
    }
    if (!where) continue;
    const std::string along = shared_mm > 0.0
                                  ? fmt::format(
                                        "touches other parts along {:.3f} mm: the cut "
                                        "along the edge takes {:.3f} mm off it there",
                                        shared_mm,
                                        half_kerf_mm)
                                  : fmt::format(
                                        "touches other parts at corners: the cut between "
                                        "them takes up to {:.3f} mm off it there",
                                        half_kerf_mm);
    warnings.push_back(
        {drawing::FaultKind::kIgnored,
         edges.drawn.contours[i].entity,
         where,
         along,
         fmt::format("draw parts the kerf apart, {:.3f} mm, if they must keep their size",
                     2.0 * half_kerf_mm)});
  }
  return warnings;
}

/// Separates the outlines of a crowd along their shared edges. Returns false if that is not
/// possible.
bool share_crowd(const DrawnEdges& edges,
                 const std::vector<std::size_t>& crowd,
                 ContourOffset& offset,
                 std::vector<PathBeside>& paths,
                 std::vector<drawing::Fault>& warnings) {
  CutsBetween between{.edges = shared_edges(edges.outlines, crowd, edges.may_share)};
  if (between.edges.edges.empty()) return false;
  const std::vector<drawing::Fault> held = held_together(edges.drawn, crowd, paths);
  const auto count_without_path = [&] {
    return std::ranges::count_if(crowd, [&](std::size_t i) { return paths[i].loops.empty(); });
  };
  const auto without_path = count_without_path();
  if (!part_crowd(edges, crowd, between, offset, paths)) return false;
  // An outline that has lost its path is cut together with another part. The warnings say so.
  if (count_without_path() > without_path) {
    warnings.insert(warnings.end(), held.begin(), held.end());
  }
  for (drawing::Fault& shared : shared_by(edges, crowd, between.edges)) {
    warnings.push_back(std::move(shared));
  }
  return true;
}

void part_crowds(const DrawnEdges& edges,
                 std::vector<PathBeside>& paths,
                 std::vector<drawing::Fault>& warnings) {
  ContourOffset offset;
  for (const auto& crowd : crowds_of(edges.outlines, paths, edges.near, edges.half_kerf_mm)) {
    if (share_crowd(edges, crowd, offset, paths, warnings)) continue;
    const std::vector<drawing::Fault> held = held_together(edges.drawn, crowd, paths);
    Middles middles = middles_beside(edges, crowd);
    const CutsBetween between{.middles = std::move(middles.rows)};
    if (!part_crowd(edges, crowd, between, offset, paths)) continue;
    if (middles.warning) {
      warnings.push_back(*middles.warning);
    } else {
      warnings.insert(warnings.end(), held.begin(), held.end());
    }
  }
}

/// Replaces the faults in `gouges` of an outline by one fault if its part lies against another
/// part.
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
