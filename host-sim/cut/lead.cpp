#include "host-sim/cut/lead.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace sim::cut {
namespace {

// The bulge of a quarter turn, tan(π / 8).
constexpr double kQuarterBulge = std::numbers::sqrt2 - 1.0;
constexpr double kDiagonal = 0.5 * std::numbers::sqrt2;

/// Returns the lead-in that has the length `length` and ends at `place` in the direction `tangent`.
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

void add(std::vector<Stroke>& row, std::vector<Stroke> more, Purpose purpose) {
  for (Stroke& stroke : more) {
    stroke.purpose = purpose;
    row.push_back(stroke);
  }
}

/// Evenly spaced tabs of a row. The uncut length of a tab, `gap_mm`, is one kerf more than the
/// width of the material that stays.
struct Tabs {
  unsigned count = 0;
  double gap_mm = 0.0;
  /// Whether the row ends at the start of its last tab, so that it is not closed.
  bool has_last_at_end = false;
};

std::vector<Stroke> tabbed(const MeasuredRow& row, const Tabs& tabs) {
  const double length = row.length();
  const double half = 0.5 * tabs.gap_mm;
  std::vector<Stroke> result;
  double done = 0.0;
  for (unsigned i = 0; i < tabs.count; ++i) {
    const double end = length * (i + 1.0) / tabs.count;
    const double middle = tabs.has_last_at_end ? end - half : end - 0.5 * length / tabs.count;
    add(result, row.stretch(done, middle - half), Purpose::kContour);
    if (tabs.has_last_at_end && i + 1 == tabs.count) return result;
    add(result, row.stretch(middle - half, middle + half), Purpose::kTab);
    done = middle + half;
  }
  add(result, row.stretch(done, length), Purpose::kContour);
  return result;
}

bool ends_at_a_tab(const LayerSettings& settings, unsigned tabs) {
  return settings.start == StartAt::kTab && tabs > 0;
}

/// Returns `tabs`, reduced until the tabs take less than half of the length of the cut.
unsigned tabs_with_room(const MeasuredRow& loop, unsigned tabs, double gap_mm) {
  while (tabs > 0 && tabs * gap_mm >= 0.5 * loop.length()) --tabs;
  return tabs;
}

/// Returns the strokes of a cut that begins at a point of its loop, without its leads.
std::vector<Stroke> body_of(const MeasuredRow& loop,
                            double way_mm,
                            const LayerSettings& settings,
                            unsigned tabs,
                            double kerf_mm) {
  const MeasuredRow row{loop.begun_at(way_mm)};
  const bool ends_at_tab = ends_at_a_tab(settings, tabs);
  std::vector<Stroke> body = tabbed(row, {tabs, settings.tab_mm + kerf_mm, ends_at_tab});
  if (!ends_at_tab) add(body, row.stretch(0.0, settings.overcut_mm), Purpose::kOvercut);
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

}  // namespace

Leads leads_at(const MeasuredRow& loop,
               double way_mm,
               const LayerSettings& settings,
               double share) {
  Leads leads;
  if (settings.lead_in.kind != LeadKind::kNone) {
    const double length = share * settings.lead_in.length_mm;
    leads.in = lead_in(settings.lead_in, length, loop.place(way_mm), loop.leaving(way_mm));
  }
  if (settings.lead_out.kind != LeadKind::kNone) {
    const double length = share * settings.lead_out.length_mm;
    const double overcut = std::min(settings.overcut_mm, loop.length());
    const double end = std::fmod(way_mm + overcut, loop.length());
    const bool ends_at_start = leads.in && end == way_mm;
    const Place place = ends_at_start ? leads.in->to : loop.place(end);
    leads.out = lead_out(settings.lead_out, length, place, loop.arriving(end));
  }
  return leads;
}

bool have_room(const Leads& leads, const LeadRoom& room) {
  const double least = room.half_kerf_mm - kClearSlackMm;
  const auto is_clear = [&](const std::optional<Stroke>& lead) {
    return !lead || room.parts.is_clear(*lead, least);
  };
  return is_clear(leads.in) && is_clear(leads.out);
}

LedCut with_leads(const MeasuredRow& loop,
                  const LayerSettings& settings,
                  unsigned tabs,
                  const LeadRoom& room,
                  const Beginning& beginning) {
  const double kerf = 2.0 * room.half_kerf_mm;
  LedCut cut{.has_leads = beginning.has_leads,
             .lead_share = beginning.lead_share,
             .tabs = tabs_with_room(loop, tabs, settings.tab_mm + kerf)};
  std::vector<Stroke> body = body_of(loop, beginning.way_mm, settings, cut.tabs, kerf);
  cut.corners = treat_corners(body, settings, room.parts, room.half_kerf_mm);
  Leads leads;
  if (beginning.has_leads) {
    leads = leads_at(loop, beginning.way_mm, settings, beginning.lead_share);
  }
  if (leads.in) cut.strokes.push_back(*leads.in);
  cut.strokes.insert(cut.strokes.end(), body.begin(), body.end());
  if (leads.out && !ends_at_a_tab(settings, cut.tabs)) cut.strokes.push_back(*leads.out);
  if (settings.pierce_s > 0.0) slow_down_start(cut.strokes);
  return cut;
}

}  // namespace sim::cut
