#include "host-sim/cut/beginning.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "host-sim/cut/corner.hpp"

namespace sim::cut {
namespace {

/// Greatest number of middles of strokes that are tried as the usual beginning, for each length of
/// the leads. Also the greatest number of ends of strokes that are tried.
constexpr std::size_t kMaxUsualSpots = 64;
constexpr std::array kLeadShares{1.0, 0.5, 0.25, 0.125};

/// A point of the loop: its distance along the loop, and the length of its stroke.
struct Spot {
  double way_mm = 0.0;
  double room_mm = 0.0;
};

bool needs_leads(const LayerSettings& settings) {
  return settings.lead_in.kind != LeadKind::kNone || settings.lead_out.kind != LeadKind::kNone;
}

/// Returns the middles of strokes, then the points between strokes. Both groups are in the order of
/// length, the longest strokes first.
std::vector<Spot> usual_spots(const MeasuredRow& loop) {
  std::vector<Spot> middles;
  std::vector<Spot> joints;
  for (std::size_t i = 0; i < loop.strokes().size(); ++i) {
    const double before = loop.way_to(i);
    const double length = loop.way_to(i + 1) - before;
    middles.push_back({before + 0.5 * length, length});
    joints.push_back({before, length});
  }
  std::ranges::stable_sort(middles, std::greater{}, &Spot::room_mm);
  std::ranges::stable_sort(joints, std::greater{}, &Spot::room_mm);
  middles.resize(std::min(middles.size(), kMaxUsualSpots));
  joints.resize(std::min(joints.size(), kMaxUsualSpots));
  middles.insert(middles.end(), joints.begin(), joints.end());
  return middles;
}

/// Returns the distances along the loop to its corners. The distance to an outer corner is the
/// distance to the middle of the arc around the corner.
std::vector<double> corner_spots(const MeasuredRow& loop,
                                 const LayerSettings& settings,
                                 double half_kerf_mm) {
  std::vector<double> spots;
  const double min_turn = settings.corner_angle_deg * std::numbers::pi / 180.0;
  for (const Corner& corner : corners_of(loop.strokes(), min_turn, half_kerf_mm)) {
    const double from = loop.way_to(corner.stroke);
    const double to = loop.way_to(corner.stroke + 1);
    spots.push_back(corner.is_outer ? 0.5 * (from + to) : from);
  }
  return spots;
}

/// Returns the distances to about `count` points that are evenly spaced on each stroke. Strokes
/// that are much shorter than the spacing have no point.
std::vector<double> stroke_spots(const MeasuredRow& loop, std::size_t count) {
  std::vector<double> spots;
  const double spacing = loop.length() / static_cast<double>(count);
  const bool has_few = loop.strokes().size() <= count;
  for (std::size_t i = 0; i < loop.strokes().size(); ++i) {
    const double length = loop.way_to(i + 1) - loop.way_to(i);
    auto here = static_cast<std::size_t>(std::lround(length / spacing));
    if (here == 0 && has_few && length > 0.25 * spacing) here = 1;
    for (std::size_t k = 0; k < here; ++k) {
      const double share = (static_cast<double>(k) + 0.5) / static_cast<double>(here);
      spots.push_back(loop.way_to(i) + share * length);
    }
  }
  if (!spots.empty()) return spots;
  for (std::size_t k = 0; k < count; ++k) {
    spots.push_back((static_cast<double>(k) + 0.5) * spacing);
  }
  return spots;
}

/// Reduces a longer list to `count` points that are evenly distributed over the list.
void thin(std::vector<double>& spots, std::size_t count) {
  if (spots.size() <= count) return;
  std::vector<double> fewer;
  for (std::size_t i = 0; i < count; ++i) fewer.push_back(spots[i * spots.size() / count]);
  spots = std::move(fewer);
}

std::vector<double> spots_of(const MeasuredRow& loop,
                             const LayerSettings& settings,
                             double half_kerf_mm,
                             const BeginningWish& wish) {
  if (wish.marked_mm) return {*wish.marked_mm};
  std::vector<double> corners;
  const bool is_any = wish.where == StartAt::kAny || wish.where == StartAt::kTab;
  if (is_any || wish.where == StartAt::kCorner) {
    corners = corner_spots(loop, settings, half_kerf_mm);
  }
  if (wish.where == StartAt::kCorner && !corners.empty()) {
    thin(corners, wish.count);
    return corners;
  }
  thin(corners, (wish.count + 1) / 2);
  const std::size_t on_strokes = std::max<std::size_t>(wish.count - corners.size(), 1);
  std::vector<double> spots = stroke_spots(loop, on_strokes);
  thin(spots, on_strokes);
  spots.insert(spots.end(), corners.begin(), corners.end());
  return spots;
}

Beginning without_leads(const MeasuredRow& loop, const LayerSettings& settings, double way_mm) {
  return moved_to({.has_leads = false}, loop, settings, way_mm);
}

}  // namespace

Beginning moved_to(const Beginning& beginning,
                   const MeasuredRow& loop,
                   const LayerSettings& settings,
                   double way_mm) {
  Beginning moved = beginning;
  moved.way_mm = way_mm;
  Leads leads;
  if (beginning.has_leads) leads = leads_at(loop, way_mm, settings, beginning.lead_share);
  moved.entry = leads.in ? leads.in->from : loop.place(way_mm);
  if (leads.out) {
    moved.exit = leads.out->to;
  } else {
    const double overcut = std::min(settings.overcut_mm, loop.length());
    moved.exit = loop.place(overcut > 0.0 ? std::fmod(way_mm + overcut, loop.length()) : way_mm);
  }
  return moved;
}

Beginning usual_beginning(const MeasuredRow& loop,
                          const LayerSettings& settings,
                          const LeadRoom& room) {
  const std::vector<Spot> spots = usual_spots(loop);
  for (const double share : kLeadShares) {
    for (const Spot& spot : spots) {
      if (!have_room(leads_at(loop, spot.way_mm, settings, share), room)) continue;
      return moved_to({.lead_share = share}, loop, settings, spot.way_mm);
    }
  }
  return without_leads(loop, settings, spots.front().way_mm);
}

std::vector<Beginning> beginnings_of(const MeasuredRow& loop,
                                     const LayerSettings& settings,
                                     const LeadRoom& room,
                                     const BeginningWish& wish) {
  const bool is_marked = wish.marked_mm.has_value();
  const Beginning usual = usual_beginning(loop, settings, room);
  if (wish.where == StartAt::kUsual && !is_marked) return {usual};
  const std::vector<double> spots = spots_of(loop, settings, room.half_kerf_mm, wish);
  std::vector<Beginning> found;
  for (const double share : kLeadShares) {
    const bool is_usual_share = usual.has_leads && share == usual.lead_share;
    if (is_usual_share && !is_marked && wish.where != StartAt::kCorner) found.push_back(usual);
    for (const double spot : spots) {
      if (!have_room(leads_at(loop, spot, settings, share), room)) continue;
      found.push_back(moved_to({.lead_share = share}, loop, settings, spot));
      if (!needs_leads(settings)) found.back().lead_share = 1.0;
    }
    if (!found.empty()) return found;
    if (is_usual_share && !is_marked && wish.where != StartAt::kCorner) return {usual};
  }
  for (const double spot : spots) found.push_back(without_leads(loop, settings, spot));
  return found;
}

std::vector<Beginning> beginnings_on_line(const MeasuredRow& loop,
                                          const LayerSettings& settings,
                                          const BeginningWish& wish) {
  LayerSettings plain = settings;
  plain.overcut_mm = 0.0;
  std::vector<Beginning> found;
  if (!wish.marked_mm) found.push_back(without_leads(loop, plain, 0.0));
  if (wish.where == StartAt::kUsual && !wish.marked_mm) return found;
  for (const double spot : spots_of(loop, plain, 0.0, wish)) {
    if (spot > 0.0 || wish.marked_mm) found.push_back(without_leads(loop, plain, spot));
  }
  return found;
}

std::vector<Beginning> beginnings_of_line(const MeasuredRow& line) {
  const Place& from = line.strokes().front().from;
  const Place& to = line.strokes().back().to;
  return {{.has_leads = false, .entry = from, .exit = to},
          {.has_leads = false, .is_backwards = true, .entry = to, .exit = from}};
}

}  // namespace sim::cut
