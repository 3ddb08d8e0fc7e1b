#include "host-sim/pocket/entry_beside.hpp"

#include <algorithm>
#include <cmath>

namespace sim::pocket {
namespace {

using cnc::WideVec2;

/// Distance from the stock at which the tool's centre descends, as a share of the tool's radius.
constexpr double kGap = 1.25;
/// Greatest distance between neighbouring candidate points, as a share of the tool's radius.
constexpr double kApart = 1.0;
/// Greatest number of candidate paths (the shortest are tried), and limits of the number of points
/// on a loop.
constexpr std::size_t kMaxWays = 1000;
constexpr double kFewestOnLoop = 16.0;
constexpr double kMaxOnLoop = 128.0;

/// A line that may lead to a point on a loop.
struct Candidate {
  WideVec2 from{0.0, 0.0};
  double way_mm = 0.0;
  double square = 0.0;  ///< Square of the line's length, mm².
};

/// Returns points along the edge of a box. Neighbouring points are at most `apart_mm` apart.
std::vector<WideVec2> places_along(const StockBox& box, double apart_mm) {
  const std::vector<WideVec2> corners{
      {box.x0, box.y0}, {box.x1, box.y0}, {box.x1, box.y1}, {box.x0, box.y1}};
  std::vector<WideVec2> places;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const WideVec2& from = corners[i];
    const WideVec2 edge = corners[(i + 1) % corners.size()] - from;
    const double count = std::ceil(edge.norm() / apart_mm);
    for (double k = 0.0; k < count; k += 1.0) places.emplace_back(from + k / count * edge);
  }
  return places;
}

}  // namespace

EntryBesideSearch::EntryBesideSearch(const OwnedArea& area,
                                     const StockBox& stock,
                                     double tool_radius_mm)
    : area_{area},
      stock_{stock},
      radius_mm_{tool_radius_mm},
      places_{places_along(widened(stock, kGap * tool_radius_mm), kApart * tool_radius_mm)} {
  std::erase_if(places_,
                [this](const WideVec2& place) { return area_->depth(place) < radius_mm_; });
}

std::optional<EntryBeside> EntryBesideSearch::find(const DrivenLoop& loop) const {
  const double count =
      std::clamp(std::ceil(loop.length() / (0.25 * radius_mm_)), kFewestOnLoop, kMaxOnLoop);
  std::vector<Candidate> candidates;
  for (double i = 0.0; i < count; i += 1.0) {
    const double way_mm = i / count * loop.length();
    const WideVec2 place = loop.row().place(way_mm);
    if (is_beside(stock_, place, radius_mm_)) return EntryBeside{place, {}, way_mm};
    for (const WideVec2& from : places_) {
      candidates.push_back({from, way_mm, (place - from).squaredNorm()});
    }
  }
  std::ranges::sort(candidates, {}, &Candidate::square);
  candidates.resize(std::min(candidates.size(), kMaxWays));
  for (const Candidate& candidate : candidates) {
    const Pose cut{loop.row().place(candidate.way_mm), loop.row().leaving(candidate.way_mm)};
    const Approach approach = fitting_approach(candidate.from, cut, area_, radius_mm_);
    if (!approach.exists) continue;
    return EntryBeside{candidate.from, approach, candidate.way_mm, std::sqrt(candidate.square)};
  }
  return std::nullopt;
}

}  // namespace sim::pocket
