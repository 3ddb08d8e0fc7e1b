#include "host-sim/cut/lead.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace sim::cut {
namespace {

/// Places to begin at that are looked at for each length of the leads.
constexpr std::size_t kMostStarts = 64;
/// The beam is measured to be clear within this; the contour itself just is, mm.
constexpr double kClearSlack = 1.0e-5;
/// Under which a pierce takes its time: too short to see, long enough to take steps, mm.
constexpr double kPierceWay = 0.1;
constexpr double kQuarterBulge = std::numbers::sqrt2 - 1.0;  // tan(π / 8).
constexpr double kDiagonal = 0.5 * std::numbers::sqrt2;

/// A place on the row, mm from its start.
struct Start {
  double way_mm;
  double room_mm;  ///< Length of the stroke around it.
};

Place right_of(const Place& way) { return {way.y(), -way.x()}; }

/// The lead that ends in `place`, going the way `tangent`; its length is that of its path.
Stroke lead_in(const Lead& lead, double length, const Place& place, const Place& tangent) {
  if (lead.kind == LeadKind::kLine) {
    const Place from = place + length * kDiagonal * (right_of(tangent) - tangent);
    return {from, place, 0.0, Purpose::kLeadIn};
  }
  const double radius = length / (0.5 * std::numbers::pi);
  const Place from = place + radius * (right_of(tangent) - tangent);
  return {from, place, -kQuarterBulge, Purpose::kLeadIn};
}

Stroke lead_out(const Lead& lead, double length, const Place& place, const Place& tangent) {
  if (lead.kind == LeadKind::kLine) {
    const Place to = place + length * kDiagonal * (right_of(tangent) + tangent);
    return {place, to, 0.0, Purpose::kLeadOut};
  }
  const double radius = length / (0.5 * std::numbers::pi);
  const Place to = place + radius * (right_of(tangent) + tangent);
  return {place, to, -kQuarterBulge, Purpose::kLeadOut};
}

/// The middles of long strokes first, then where strokes meet.
std::vector<Start> starts_of(const std::vector<Stroke>& loop) {
  std::vector<Start> middles;
  std::vector<Start> corners;
  double before = 0.0;
  for (const Stroke& stroke : loop) {
    const double length = length_of(stroke);
    middles.push_back({before + 0.5 * length, length});
    corners.push_back({before, length});
    before += length;
  }
  std::ranges::stable_sort(middles, std::greater{}, &Start::room_mm);
  std::ranges::stable_sort(corners, std::greater{}, &Start::room_mm);
  middles.resize(std::min(middles.size(), kMostStarts));
  corners.resize(std::min(corners.size(), kMostStarts));
  middles.insert(middles.end(), corners.begin(), corners.end());
  return middles;
}

std::vector<Stroke> begun_at(const std::vector<Stroke>& loop, double way_mm) {
  const double length = length_of(loop);
  std::vector<Stroke> row = stretch_of(loop, way_mm, length);
  const std::vector<Stroke> rest = stretch_of(loop, 0.0, way_mm);
  row.insert(row.end(), rest.begin(), rest.end());
  return row;
}

void add(std::vector<Stroke>& row, std::vector<Stroke> more, Purpose purpose) {
  for (Stroke& stroke : more) {
    stroke.purpose = purpose;
    row.push_back(stroke);
  }
}

/// What is left standing is a kerf less than what is not cut.
std::vector<Stroke> tabbed(const std::vector<Stroke>& row, unsigned tabs, double gap_mm) {
  const double length = length_of(row);
  std::vector<Stroke> result;
  double done = 0.0;
  for (unsigned i = 0; i < tabs; ++i) {
    const double middle = length * (i + 0.5) / tabs;
    add(result, stretch_of(row, done, middle - 0.5 * gap_mm), Purpose::kContour);
    add(result, stretch_of(row, middle - 0.5 * gap_mm, middle + 0.5 * gap_mm), Purpose::kTab);
    done = middle + 0.5 * gap_mm;
  }
  add(result, stretch_of(row, done, length), Purpose::kContour);
  return result;
}

/// The cut without its leads, from a place on.
std::vector<Stroke> body_of(const std::vector<Stroke>& loop,
                            double way_mm,
                            const LayerSettings& settings,
                            unsigned tabs,
                            double kerf_mm) {
  const std::vector<Stroke> row = begun_at(loop, way_mm);
  const double gap = settings.tab_mm + kerf_mm;
  const bool room_for_tabs = tabs * gap < 0.5 * length_of(row);
  std::vector<Stroke> body = tabbed(row, room_for_tabs ? tabs : 0, gap);
  add(body, stretch_of(row, 0.0, settings.overcut_mm), Purpose::kOvercut);
  return body;
}

void slow_down_start(std::vector<Stroke>& strokes) {
  const Stroke first = strokes.front();
  const double length = length_of(first);
  if (length <= 2.0 * kPierceWay) {
    strokes.front().purpose = Purpose::kPierce;
    return;
  }
  Stroke pierce = part_of(first, 0.0, kPierceWay / length);
  pierce.purpose = Purpose::kPierce;
  strokes.front() = part_of(first, kPierceWay / length, 1.0);
  strokes.front().from = pierce.to;
  strokes.insert(strokes.begin(), pierce);
}

/// True where both leads of this share of their length have room; they are then added.
bool add_leads(std::vector<Stroke>& body,
               const LayerSettings& settings,
               double share,
               const LeadRoom& room) {
  const double least = room.half_kerf_mm - kClearSlack;
  const Stroke in = lead_in(settings.lead_in,
                            share * settings.lead_in.length_mm,
                            body.front().from,
                            tangent_at(body.front(), 0.0));
  const Stroke out = lead_out(settings.lead_out,
                              share * settings.lead_out.length_mm,
                              body.back().to,
                              tangent_at(body.back(), 1.0));
  const bool has_in = settings.lead_in.kind != LeadKind::kNone;
  const bool has_out = settings.lead_out.kind != LeadKind::kNone;
  if (has_in && !room.parts.is_clear(in, least)) return false;
  if (has_out && !room.parts.is_clear(out, least)) return false;
  if (has_in) body.insert(body.begin(), in);
  if (has_out) body.push_back(out);
  return true;
}

}  // namespace

LedCut with_leads(const std::vector<Stroke>& loop,
                  const LayerSettings& settings,
                  unsigned tabs,
                  const LeadRoom& room) {
  const std::vector<Start> starts = starts_of(loop);
  const auto body_at = [&](const Start& start) {
    return body_of(loop, start.way_mm, settings, tabs, 2.0 * room.half_kerf_mm);
  };
  LedCut cut;
  for (const double share : {1.0, 0.5, 0.25, 0.125}) {
    for (const Start& start : starts) {
      cut.strokes = body_at(start);
      cut.has_leads = add_leads(cut.strokes, settings, share, room);
      if (cut.has_leads) break;
    }
    if (cut.has_leads) break;
  }
  if (!cut.has_leads) cut.strokes = body_at(starts.front());
  if (settings.pierce_s > 0.0) slow_down_start(cut.strokes);
  return cut;
}

}  // namespace sim::cut
