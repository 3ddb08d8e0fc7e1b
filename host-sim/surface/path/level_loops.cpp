#include "host-sim/surface/path/level_loops.hpp"

#include <algorithm>
#include <utility>

namespace sim::surface {
namespace {

/// Distance, mm, below which successive points count as the same point.
constexpr double kSameCrossing = 1.0e-6;
/// Length, mm, up to which loops are left out.
constexpr double kMinLoop = 1.0e-3;

double length_of(const std::vector<Eigen::Vector2d>& places) {
  double length = 0.0;
  for (std::size_t i = 1; i < places.size(); ++i) length += (places[i] - places[i - 1]).norm();
  return length;
}

/// Returns whether the complete straight line between two points is in all regions.
bool is_within(const MilledRegions& regions,
               const Eigen::Vector2d& from,
               const Eigen::Vector2d& to) {
  const Slice slice = slice_between(from, to);
  const SliceParts parts = common_parts(regions, slice, {{0.0, slice.length}});
  return parts.size() == 1 && parts[0].first < kSameCrossing &&
         parts[0].second > slice.length - kSameCrossing;
}

}  // namespace

void open_near(const Eigen::Vector2d& here, LevelLoop& loop) {
  const auto nearest = std::ranges::min_element(
      loop.places, {}, [&here](const Eigen::Vector2d& place) { return (place - here).norm(); });
  std::rotate(loop.places.begin(), nearest, loop.places.end());
  const Eigen::Vector2d first = loop.places.front();
  loop.places.push_back(first);
  loop.is_closed = false;
}

/// If a point of the surface is above a level, the tip is above the level within a disc around this
/// point. A disc that is as wide as a cell's diagonal contains a node. The grid then finds the
/// point.
double level_pitch(const SurfaceTracer& tracer) {
  constexpr double kShareOfRadius = 0.125;
  const cnc::surface::Profile& tool = tracer.grown_tool();
  const double disc = cnc::surface::radius_below(tool, tool.tip_mm + tracer.band_mm());
  return std::min(1.4 * disc, kShareOfRadius * tool.radius_mm);
}

std::vector<LevelLoop> loops_of(const LevelSet& set,
                                const PlanGrid& grid,
                                const std::function<NodeSide(std::size_t)>& side_of,
                                std::size_t level) {
  const auto is_high_in_middle = [&](std::size_t node) {
    return set.above(grid.at(node) + 0.5 * grid.pitch()) > 0.0;
  };
  std::vector<LevelLoop> loops;
  for (const IsoLine& line : iso_lines(grid, side_of, is_high_in_middle)) {
    LevelLoop loop{
        .level = level, .level_mm = set.level_mm(), .places = {}, .is_closed = line.is_closed};
    for (const CrossedEdge& edge : line.edges) {
      const Eigen::Vector2d place = set.crossing(grid.at(edge.low), grid.at(edge.high));
      const bool is_same =
          !loop.places.empty() && (place - loop.places.back()).norm() < kSameCrossing;
      if (!is_same) loop.places.push_back(place);
    }
    if (line.is_closed && (loop.places.front() - loop.places.back()).norm() < kSameCrossing) {
      loop.places.pop_back();
    }
    if (loop.places.size() > 1 && length_of(loop.places) > kMinLoop) {
      loops.push_back(std::move(loop));
    }
  }
  return loops;
}

std::vector<LevelLoop> level_loops(const SurfaceTracer& tracer,
                                   const TipGrid& tips,
                                   std::size_t level,
                                   double level_mm) {
  const auto side_of = [&](std::size_t node) {
    if (!tips.has_contact(node)) return NodeSide::kNone;
    return tips.height(node) > level_mm ? NodeSide::kHigh : NodeSide::kLow;
  };
  return loops_of(LevelSet{tracer, level_mm}, tips.grid(), side_of, level);
}

std::vector<LevelLoop> parts_within(const MilledRegions& regions, LevelLoop loop) {
  std::vector<LevelLoop> parts;
  if (regions.empty()) {
    parts.push_back(std::move(loop));
    return parts;
  }
  const std::size_t ways = loop.places.size() - (loop.is_closed ? 0 : 1);
  const auto end_of = [&loop](std::size_t way) {
    return loop.places[(way + 1) % loop.places.size()];
  };
  std::vector<bool> is_in(ways);
  for (std::size_t i = 0; i < ways; ++i) {
    is_in[i] = is_within(regions, loop.places[i], end_of(i));
  }
  const auto first_out = std::ranges::find(is_in, false);
  if (first_out == is_in.end()) {
    parts.push_back(std::move(loop));
    return parts;
  }
  // The search in a closed loop begins outside the regions, so that it cuts no part in two.
  const auto first = static_cast<std::size_t>(first_out - is_in.begin());
  const std::size_t begin = loop.is_closed ? first : 0;
  bool goes_on = false;
  for (std::size_t i = 0; i < ways; ++i) {
    const std::size_t way = (begin + i) % ways;
    if (is_in[way] && !goes_on) {
      parts.push_back({loop.level, loop.level_mm, {loop.places[way]}, false});
    }
    if (is_in[way]) parts.back().places.push_back(end_of(way));
    goes_on = is_in[way];
  }
  return parts;
}

}  // namespace sim::surface
