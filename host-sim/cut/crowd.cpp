#include "host-sim/cut/crowd.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <optional>

#include "host-sim/contour/contour_loops.hpp"
#include "host-sim/cut/edge_paths.hpp"
#include "host-sim/cut/filled_area.hpp"
#include "host-sim/import/piece_sets.hpp"

namespace sim::cut {
namespace {

using Rows = std::vector<std::vector<Stroke>>;

struct Extremes {
  Place least{std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
  Place most{-least};
};

Extremes extremes_of(const std::vector<Stroke>& row) {
  Extremes extremes;
  for (const Stroke& stroke : row) {
    extremes.least = extremes.least.cwiseMin(stroke.from);
    extremes.most = extremes.most.cwiseMax(stroke.from);
  }
  return extremes;
}

bool holds(const Extremes& outer, const Extremes& inner) {
  return (inner.least - outer.least).minCoeff() >= 0.0 &&
         (outer.most - inner.most).minCoeff() >= 0.0;
}

/// Adds a frame around a crowd to `region` if the crowd contains a hole, but not the outline of the
/// part that has this hole. The frame stands for the material of the part around the hole.
/// @return whether a frame was added
bool frame_holes(const std::vector<Outline>& outlines,
                 const std::vector<std::size_t>& crowd,
                 double half_kerf_mm,
                 Contour& region) {
  Extremes all;
  std::vector<Extremes> extremes;
  for (const std::size_t i : crowd) {
    extremes.push_back(extremes_of(outlines[i].strokes));
    all.least = all.least.cwiseMin(extremes.back().least);
    all.most = all.most.cwiseMax(extremes.back().most);
  }
  bool has_frame = false;
  for (std::size_t k = 0; k < crowd.size(); ++k) {
    if (!outlines[crowd[k]].is_hole) continue;
    const bool has_outer = std::ranges::any_of(crowd, [&](std::size_t other) {
      return !outlines[other].is_hole && holds(extremes_of(outlines[other].strokes), extremes[k]);
    });
    has_frame = has_frame || !has_outer;
  }
  if (!has_frame) return false;
  const double margin = 10.0 * half_kerf_mm + (all.most - all.least).maxCoeff();
  const Place least = all.least - Place::Constant(margin);
  const Place most = all.most + Place::Constant(margin);
  append_rectangle(least, most, region);
  return true;
}

/// Returns the outline of a crowd that is nearest to the middle of a path's first stroke.
std::size_t owner_of(const std::vector<Stroke>& loop,
                     const std::vector<Outline>& outlines,
                     const std::vector<std::size_t>& crowd) {
  const Place place = place_at(loop.front(), 0.5);
  std::size_t owner = crowd.front();
  double nearest = std::numeric_limits<double>::infinity();
  for (const std::size_t i : crowd) {
    for (const Stroke& stroke : outlines[i].strokes) {
      const double apart = distance_to(stroke, place);
      if (apart >= nearest) continue;
      nearest = apart;
      owner = i;
    }
  }
  return owner;
}

/// Returns the offset paths of the region that all outlines of a crowd enclose together; nothing if
/// there is no offset.
/// @param by_turns whether outlines lie against each other, so that they may overlap by rounding
std::optional<Rows> paths_of(const std::vector<Outline>& outlines,
                             const std::vector<std::size_t>& crowd,
                             double half_kerf_mm,
                             bool by_turns,
                             ContourOffset& offset) {
  Contour region;
  const bool has_frame = frame_holes(outlines, crowd, half_kerf_mm, region);
  for (const std::size_t i : crowd) {
    append_loops(contour_of(outlines[i].strokes).view(), region);
  }
  try {
    if (by_turns) region = filled_area(region, FilledBy::kTurns);
    Rows loops = loops_of(offset.offset(region.view(), half_kerf_mm));
    if (!has_frame) return loops;
    // The path along the frame encloses all others, so it has the largest area.
    const auto frame = std::ranges::max_element(
        loops, {}, [](const std::vector<Stroke>& loop) { return area_of(loop); });
    if (frame != loops.end()) loops.erase(frame);
    return loops;
  } catch (const NoOffset&) {
    return std::nullopt;
  }
}

/// Returns all rows along which the beam is driven, around outlines and between them.
Rows driven_of(const Rows& around, const CutsBetween& between) {
  Rows driven = around;
  driven.insert(driven.end(), between.middles.begin(), between.middles.end());
  for (const SharedEdge& edge : between.edges.edges) {
    if (!edge.strokes.empty()) driven.push_back(edge.strokes);
  }
  return driven;
}

/// Returns the uncut stretches of each outline of a crowd. Returns nothing if a stretch is longer
/// than kMaxHoldMm, unless it would stay uncut even without the other outlines.
std::optional<std::vector<std::vector<Rest>>> rests_of_crowd(
    const DrawnEdges& edges,
    const std::vector<std::size_t>& crowd,
    const Rows& driven,
    const std::vector<PathBeside>& beside) {
  const double half_kerf_mm = edges.half_kerf_mm(crowd.front());
  const double reach_mm = 4.0 * half_kerf_mm;
  std::vector<std::vector<Rest>> rests;
  for (const std::size_t i : crowd) {
    rests.push_back(rests_along(edges.outlines[i].strokes, driven, half_kerf_mm, reach_mm));
    for (const Rest& rest : rests.back()) {
      const auto is_as_long = [&](const Rest& own) {
        return own.length_mm >= rest.length_mm - 1.0e-9;
      };
      const bool is_slot =
          beside[i].loops.empty() || std::ranges::any_of(beside[i].rests, is_as_long);
      if (rest.length_mm > kMaxHoldMm && !is_slot) return std::nullopt;
    }
  }
  return rests;
}

}  // namespace

std::vector<std::vector<std::size_t>> crowds_of(
    const std::vector<Outline>& outlines,
    const std::vector<PathBeside>& beside,
    const Clearance& edges,
    const std::function<double(std::size_t)>& half_kerf_mm) {
  drawing::PieceSets sets{outlines.size()};
  std::vector<bool> is_in(outlines.size(), false);
  std::vector<bool> is_mixed(outlines.size(), false);
  for (std::size_t i = 0; i < outlines.size(); ++i) {
    if (beside[i].gouges.empty()) continue;
    is_in[i] = true;
    for (const Stroke& stroke : outlines[i].strokes) {
      for (const std::size_t near : edges.owners_near(stroke, 2.0 * half_kerf_mm(i))) {
        is_in[near] = true;
        is_mixed[near] = is_mixed[near] || half_kerf_mm(near) != half_kerf_mm(i);
        sets.unite(i, near);
      }
    }
  }
  std::map<std::size_t, std::vector<std::size_t>> crowds;
  for (std::size_t i = 0; i < outlines.size(); ++i) {
    if (is_in[i]) crowds[sets.find(i)].push_back(i);
  }
  std::vector<std::vector<std::size_t>> list;
  for (auto& [set, crowd] : crowds) {
    const auto is_other = [&](std::size_t i) { return is_mixed[i]; };
    if (std::ranges::none_of(crowd, is_other)) list.push_back(std::move(crowd));
  }
  return list;
}

std::vector<drawing::Fault> held_together(const drawing::Drawing& drawn,
                                          const std::vector<std::size_t>& crowd,
                                          const std::vector<PathBeside>& beside) {
  for (const std::size_t i : crowd) {
    if (beside[i].gouges.empty()) continue;
    drawing::Fault held = beside[i].gouges.front();
    held.reason = fmt::format(
        "comes nearer to an edge than the kerf, {} contour{} in all; no cut is made between the "
        "parts, which hold together there",
        crowd.size(),
        crowd.size() == 1 ? "" : "s");
    held.entity = drawn.contours[i].entity;
    return {std::move(held)};
  }
  return {};
}

bool part_crowd(const DrawnEdges& edges,
                const std::vector<std::size_t>& crowd,
                const CutsBetween& between,
                ContourOffset& offset,
                std::vector<PathBeside>& beside) {
  const double half_kerf_mm = edges.half_kerf_mm(crowd.front());
  const bool shares = !between.edges.edges.empty();
  const auto around = paths_of(edges.outlines, crowd, half_kerf_mm, shares, offset);
  if (!around) return false;
  EdgePaths paths{.is_divided = std::vector<bool>(around->size())};
  if (shares) {
    auto along =
        paths_along_edges(edges.outlines, between.edges, *around, edges.near, half_kerf_mm);
    if (!along) return false;
    paths = *std::move(along);
  }
  const auto rests = rests_of_crowd(edges, crowd, driven_of(*around, between), beside);
  if (!rests) return false;
  for (std::size_t k = 0; k < crowd.size(); ++k) {
    const auto own = paths.of_contour.find(crowd[k]);
    const bool shares_edges = own != paths.of_contour.end();
    PathBeside& path = beside[crowd[k]];
    path.loops = shares_edges ? Rows{own->second} : Rows{};
    path.shares_edges = shares_edges;
    path.vanishes = path.vanishes && !shares_edges;
    path.middles.clear();
    path.narrow.reset();
    path.gouges.clear();
    path.rests = (*rests)[k];
  }
  for (std::size_t i = 0; i < around->size(); ++i) {
    if (paths.is_divided[i]) continue;
    beside[owner_of((*around)[i], edges.outlines, crowd)].loops.push_back((*around)[i]);
  }
  const auto longest = std::ranges::max_element(
      *around, {}, [](const std::vector<Stroke>& loop) { return std::abs(area_of(loop)); });
  const bool has_path = longest != around->end();
  beside[has_path ? owner_of(*longest, edges.outlines, crowd) : crowd.front()].middles =
      between.middles;
  return true;
}

}  // namespace sim::cut
