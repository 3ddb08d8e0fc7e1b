#include "host-sim/cut/lead.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

namespace sim::cut {
namespace {

/// Places to begin at that are looked at for each length of the leads.
constexpr std::size_t kMostStarts = 64;
constexpr double kQuarterBulge = std::numbers::sqrt2 - 1.0;  // tan(π / 8).
constexpr double kDiagonal = 0.5 * std::numbers::sqrt2;

/// A place on the row, mm from its start.
struct Start {
  double way_mm = 0.0;
  double room_mm = 0.0;  ///< Length of the stroke around it.
};

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
std::vector<Start> starts_of(const MeasuredRow& loop) {
  std::vector<Start> middles;
  std::vector<Start> corners;
  for (std::size_t i = 0; i < loop.strokes().size(); ++i) {
    const double before = loop.way_to(i);
    const double length = loop.way_to(i + 1) - before;
    middles.push_back({before + 0.5 * length, length});
    corners.push_back({before, length});
  }
  std::ranges::stable_sort(middles, std::greater{}, &Start::room_mm);
  std::ranges::stable_sort(corners, std::greater{}, &Start::room_mm);
  middles.resize(std::min(middles.size(), kMostStarts));
  corners.resize(std::min(corners.size(), kMostStarts));
  middles.insert(middles.end(), corners.begin(), corners.end());
  return middles;
}

void add(std::vector<Stroke>& row, std::vector<Stroke> more, Purpose purpose) {
  for (Stroke& stroke : more) {
    stroke.purpose = purpose;
    row.push_back(stroke);
  }
}

/// What is left standing is a kerf less than what is not cut.
std::vector<Stroke> tabbed(const MeasuredRow& row, unsigned tabs, double gap_mm) {
  const double length = row.length();
  std::vector<Stroke> result;
  double done = 0.0;
  for (unsigned i = 0; i < tabs; ++i) {
    const double middle = length * (i + 0.5) / tabs;
    add(result, row.stretch(done, middle - 0.5 * gap_mm), Purpose::kContour);
    add(result, row.stretch(middle - 0.5 * gap_mm, middle + 0.5 * gap_mm), Purpose::kTab);
    done = middle + 0.5 * gap_mm;
  }
  add(result, row.stretch(done, length), Purpose::kContour);
  return result;
}

/// Tabs take less than half of the cut.
unsigned tabs_with_room(const MeasuredRow& loop, unsigned tabs, double gap_mm) {
  while (tabs > 0 && tabs * gap_mm >= 0.5 * loop.length()) --tabs;
  return tabs;
}

/// The cut without its leads, from a place on.
std::vector<Stroke> body_of(const MeasuredRow& loop,
                            double way_mm,
                            const LayerSettings& settings,
                            unsigned tabs,
                            double kerf_mm) {
  const MeasuredRow row{loop.begun_at(way_mm)};
  std::vector<Stroke> body = tabbed(row, tabs, settings.tab_mm + kerf_mm);
  add(body, row.stretch(0.0, settings.overcut_mm), Purpose::kOvercut);
  return body;
}

void slow_down_start(std::vector<Stroke>& strokes) {
  const Stroke first = strokes.front();
  const double length = length_of(first);
  if (length <= 2.0 * kPierceWayMm) {
    strokes.front().purpose = Purpose::kPierce;
    return;
  }
  Stroke pierce = part_of(first, 0.0, kPierceWayMm / length);
  pierce.purpose = Purpose::kPierce;
  strokes.front() = part_of(first, kPierceWayMm / length, 1.0);
  strokes.front().from = pierce.to;
  strokes.insert(strokes.begin(), pierce);
}

/// Both leads of a cut that begins at a place of its contour; no strokes where none are asked for.
struct Leads {
  std::vector<Stroke> in{};
  std::vector<Stroke> out{};
};

/// Nothing where one of them, at this share of its length, has no room.
std::optional<Leads> leads_at(const MeasuredRow& loop,
                              double way_mm,
                              const LayerSettings& settings,
                              double share,
                              const LeadRoom& room) {
  const double least = room.half_kerf_mm - kClearSlackMm;
  Leads leads;
  if (settings.lead_in.kind != LeadKind::kNone) {
    const double length = share * settings.lead_in.length_mm;
    leads.in = {lead_in(settings.lead_in, length, loop.place(way_mm), loop.leaving(way_mm))};
    if (!room.parts.is_clear(leads.in.front(), least)) return std::nullopt;
  }
  if (settings.lead_out.kind != LeadKind::kNone) {
    const double length = share * settings.lead_out.length_mm;
    const double overcut = std::min(settings.overcut_mm, loop.length());
    const double end = std::fmod(way_mm + overcut, loop.length());
    leads.out = {lead_out(settings.lead_out, length, loop.place(end), loop.arriving(end))};
    if (!room.parts.is_clear(leads.out.front(), least)) return std::nullopt;
  }
  return leads;
}

/// Where the leads have most room, and that share of them; none where they have no room.
struct Beginning {
  Start start{};
  std::optional<Leads> leads{};
  double share = 1.0;
};

Beginning beginning_of(const MeasuredRow& loop,
                       const LayerSettings& settings,
                       const LeadRoom& room) {
  const std::vector<Start> starts = starts_of(loop);
  for (const double share : {1.0, 0.5, 0.25, 0.125}) {
    for (const Start& start : starts) {
      if (auto leads = leads_at(loop, start.way_mm, settings, share, room)) {
        return {start, std::move(leads), share};
      }
    }
  }
  return {starts.front(), std::nullopt};
}

}  // namespace

LedCut with_leads(const MeasuredRow& loop,
                  const LayerSettings& settings,
                  unsigned tabs,
                  const LeadRoom& room) {
  const Beginning beginning = beginning_of(loop, settings, room);
  const double kerf = 2.0 * room.half_kerf_mm;
  LedCut cut{.has_leads = beginning.leads.has_value(),
             .lead_share = beginning.share,
             .tabs = tabs_with_room(loop, tabs, settings.tab_mm + kerf)};
  std::vector<Stroke> body = body_of(loop, beginning.start.way_mm, settings, cut.tabs, kerf);
  cut.corners = treat_corners(body, settings, room.parts, room.half_kerf_mm);
  if (beginning.leads) cut.strokes = beginning.leads->in;
  cut.strokes.insert(cut.strokes.end(), body.begin(), body.end());
  if (beginning.leads) {
    const auto& out = beginning.leads->out;
    cut.strokes.insert(cut.strokes.end(), out.begin(), out.end());
  }
  if (settings.pierce_s > 0.0) slow_down_start(cut.strokes);
  return cut;
}

}  // namespace sim::cut
