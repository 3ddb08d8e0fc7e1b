#include "host-sim/cut/rapid_router.hpp"

#include <algorithm>
#include <array>
#include <limits>

#include "host-sim/cut/rapid_search.hpp"
#include "host-sim/cut/segment_distance.hpp"

namespace sim::cut {
namespace {

/// Greatest number of points at which a rapid may leave the piece that was just cut. A path nearly
/// always exists from the nearest of these points.
constexpr std::size_t kMaxExits = 12;
/// Number of exits from which the search may fail before it ends. Usually all exits lead to the
/// same waste.
constexpr int kMaxSearches = 3;
/// For a rapid that leaves the piece straight towards its goal: greatest ratio of its path inside
/// the piece to the shortest path out of the piece.
constexpr double kSlantedExit = 1.5;

/// Number of legs that are tried from one end before the search from the other end begins, and
/// number of legs that are tried in total.
constexpr std::uint64_t kFirstTrials = 2'000;
constexpr std::uint64_t kMaxTrials = 40'000;

/// A path out of an area, which crosses the edge at the nearest point of one stroke.
struct RapidExit {
  double edge_mm = 0.0;  ///< Distance from the start of the rapid to this point of the edge.
  Place place{0.0, 0.0};
};

Place outward_at(const Stroke& stroke, const Place& place) {
  if (stroke.bulge == 0.0) return right_of((stroke.to - stroke.from).normalized());
  const Place away = (place - arc_centre(stroke)).normalized();
  return stroke.bulge > 0.0 ? away : -away;
}

std::vector<RapidExit> exits_of(const LoopArea& area, const Place& from, double clearance_mm) {
  constexpr double kOnEdge = 1.0e-6;
  const bool is_inside = area.contains(from);
  const double beyond = area.skin_mm() + 1.001 * clearance_mm + 1.0e-6;
  std::vector<RapidExit> exits;
  for (const Stroke& stroke : area.strokes()) {
    const Place edge = nearest_on(stroke, from);
    const double away = drawing::distance(edge, from);
    const Place out = away < kOnEdge ? outward_at(stroke, edge)
                                     : Place{(is_inside ? 1.0 : -1.0) / away * (edge - from)};
    exits.push_back({away, edge + beyond * out});
    // A cut may end at the start of an arc, next to another area. Then the only exit may be farther
    // along the arc.
    if (stroke.bulge == 0.0 || away >= kOnEdge) continue;
    for (const double share : {0.25, 0.5, 0.75, 1.0}) {
      const Place along = place_at(stroke, share);
      exits.push_back({drawing::distance(along, from), along + beyond * outward_at(stroke, along)});
    }
  }
  std::ranges::stable_sort(exits, {}, &RapidExit::edge_mm);
  if (exits.size() > kMaxExits) exits.resize(kMaxExits);
  return exits;
}

/// Returns whether a segment crosses the edge of an area at most once, without counting its start.
bool leaves_once(const LoopArea& area, const Place& from, const Place& to) {
  constexpr double kSameMm = 1.0e-5;
  const double length = drawing::distance(from, to);
  std::vector<double> shares;
  for (const Stroke& stroke : area.strokes()) add_meetings(from, to, stroke, shares);
  std::erase_if(shares, [length](double share) { return share * length < kSameMm; });
  if (shares.empty()) return true;
  const auto [first, last] = std::ranges::minmax(shares);
  return (last - first) * length < kSameMm;
}

/// Returns whether a straight leg leaves an area after at most kSlantedExit times `exit_mm`, and
/// keeps clear of the area from there on.
bool leaves_shortly(
    const LoopArea& area, const Place& from, const Place& to, double exit_mm, double clearance_mm) {
  const double length = drawing::distance(from, to);
  const double inside = kSlantedExit * exit_mm;
  if (length <= inside) return false;
  const Place out = from + inside / length * (to - from);
  return !area.contains(out) && !area.comes_near(out, to, clearance_mm) &&
         leaves_once(area, from, out);
}

/// Removes corners of a path where a straight leg between the points before and after them is free.
void shorten(std::vector<Place>& way,
             const FreeLegs& legs,
             const RapidEnd& from,
             const RapidEnd& to) {
  for (std::size_t i = 0; i + 2 < way.size(); ++i) {
    for (std::size_t k = way.size() - 1; k > i + 1; --k) {
      const RapidEnd* const begin = i == 0 ? &from : nullptr;
      const RapidEnd* const end = k + 1 == way.size() ? &to : nullptr;
      if (legs.blocker(way[i], way[k], begin, end)) continue;
      way.erase(way.begin() + static_cast<std::ptrdiff_t>(i) + 1,
                way.begin() + static_cast<std::ptrdiff_t>(k));
      break;
    }
  }
}

}  // namespace

std::vector<Place> RapidRouter::find(const Place& from,
                                     const Place& to,
                                     std::optional<std::uint32_t> just_cut) const {
  constexpr double kFar = std::numeric_limits<double>::max();
  constexpr std::array kShares{1.0, 0.25, 0.0625};
  for (const Place& lowest : {rules_.lowest, Place{-kFar, -kFar}}) {
    bool was_bounded = false;
    for (const double share : kShares) {
      Try t{{*areas_, share * rules_.clearance_mm, rules_.depth_mm}, lowest};
      if (t.legs.area_around(to) || t.legs.area_around(from, just_cut)) return {};
      const RapidEnd begin = t.legs.end_at(from);
      const RapidEnd end = t.legs.end_at(to);
      std::vector<Place> way = just_cut ? find_out(t, begin, end, *just_cut) : find(t, begin, end);
      if (!way.empty()) return way;
      was_bounded = was_bounded || t.was_bounded;
    }
    if (!was_bounded) break;
  }
  return {};
}

/// Searches from both ends. If areas enclose one end, the search from this end finishes soon.
std::vector<Place> RapidRouter::search(Try& t, const RapidEnd& from, const RapidEnd& to) {
  using Outcome = RapidSearch::Outcome;
  RapidSearch there{t.legs, from, to, t.lowest};
  RapidSearch back{t.legs, to, from, t.lowest};
  Outcome outcome = there.find(kFirstTrials);
  if (outcome == Outcome::kGaveUp && back.find(kFirstTrials) == Outcome::kNoWay) {
    outcome = Outcome::kNoWay;
  }
  if (outcome == Outcome::kGaveUp) outcome = there.find(kMaxTrials);
  t.was_bounded = t.was_bounded || there.was_bounded() || back.was_bounded();
  return outcome == Outcome::kFound ? there.way() : std::vector<Place>{};
}

std::vector<Place> RapidRouter::find(Try& t, const RapidEnd& from, const RapidEnd& to) {
  if (!t.legs.blocker(from.place, to.place, &from, &to)) return {from.place, to.place};
  std::vector<Place> way = search(t, from, to);
  shorten(way, t.legs, from, to);
  return way;
}

std::vector<Place> RapidRouter::find_out(Try& t,
                                         const RapidEnd& from,
                                         const RapidEnd& to,
                                         std::uint32_t just_cut) const {
  const FreeLegs& legs = t.legs;
  const LoopArea& area = areas_->area(just_cut);
  const double clearance = legs.clearance_mm() + area.skin_mm();
  const double edge = area.distance_to_loop(from.place);
  const bool is_inside = area.contains(from.place);
  if (!is_inside && edge >= clearance) return find(t, from, to);
  const double exit_mm = is_inside ? edge + clearance : clearance - edge;
  if (!legs.blocker(from.place, to.place, &from, &to, just_cut) &&
      leaves_shortly(area, from.place, to.place, exit_mm, clearance)) {
    return {from.place, to.place};
  }
  int searches = 0;
  const std::vector<RapidExit> exits = exits_of(area, from.place, legs.clearance_mm());
  // A farther exit is on the other side of the piece. A rapid through it would cross the piece.
  const double farthest = kSlantedExit * exits.front().edge_mm + 2.0 * rules_.clearance_mm;
  for (const RapidExit& exit : exits) {
    if (exit.edge_mm > farthest) break;
    const RapidEnd out = legs.end_at(exit.place);
    if (!out.near.empty() || legs.area_at(exit.place)) continue;
    if (!leaves_once(area, from.place, exit.place)) continue;
    if (legs.blocker(from.place, exit.place, &from, nullptr, just_cut)) continue;
    std::vector<Place> way = find(t, out, to);
    if (way.empty() && ++searches == kMaxSearches) break;
    if (way.empty()) continue;
    const RapidEnd* const end = way.size() == 2 ? &to : nullptr;
    const bool skips = !legs.blocker(from.place, way[1], &from, end, just_cut) &&
                       leaves_shortly(area, from.place, way[1], exit_mm, clearance);
    if (skips) {
      way.front() = from.place;
    } else {
      way.insert(way.begin(), from.place);
    }
    return way;
  }
  return {};
}

}  // namespace sim::cut
