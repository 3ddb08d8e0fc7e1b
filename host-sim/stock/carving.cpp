#include "host-sim/stock/carving.hpp"

#include <cmath>

namespace sim::stock {
namespace {

/// Returns whether a stretch descends more steeply than 45 degrees. The descent must also exceed
/// the distance in plan by more than `trail_mm`, so that a few steps are not a plunge.
bool is_plunge(const Stretch& stretch, double trail_mm) {
  const double level =
      std::hypot(stretch.to.x_mm - stretch.from.x_mm, stretch.to.y_mm - stretch.from.y_mm);
  return stretch.from.z_mm - stretch.to.z_mm > level + trail_mm;
}

}  // namespace

void LineCuts::add(const DrivenStretch& driven, double removed_mm3) {
  if (count == 0 || last_line != driven.origin.line) {
    ++count;
    last_line = driven.origin.line;
    if (count <= kMaxListed) lines.push_back({last_line, 0.0, driven.end_s, driven.stretch.to});
  }
  if (count <= kMaxListed) lines.back().min_mm3 += removed_mm3;
}

Carving::Carving(Stock& stock, const Cutter& cutter, double trail_mm)
    : stock_{stock}, cutter_{cutter}, trail_mm_{trail_mm}, carver_{stock, cutter} {}

void Carving::measure_engagement(const DrivenStretch& driven) {
  const Engagement found = greatest_engagement(stock_, 0.5 * cutter_.diameter_mm, driven.stretch);
  const double before = figures_.engagement ? figures_.engagement->engagement.middle_deg() : 0.0;
  if (found.middle_deg() <= before) return;
  figures_.engagement = {found, driven.origin.line, driven.end_s, driven.stretch.to};
}

void Carving::take(const DrivenStretch& driven) {
  const bool is_rapid = driven.origin.drive == Drive::kRapid;
  const bool is_feed = driven.origin.drive == Drive::kFeed;
  const bool plunges = is_feed && is_plunge(driven.stretch, trail_mm_);
  if (cutter_.kind == CutterKind::kFlat && is_feed && !plunges) measure_engagement(driven);
  const double skin_mm = is_rapid || plunges ? trail_mm_ : 0.0;
  const double removed_mm3 = carver_.sweep(driven.stretch, skin_mm);
  if (removed_mm3 > 0.0) {
    if (is_rapid) {
      figures_.rapids.add(driven, removed_mm3);
    } else if (plunges) {
      figures_.plunges.add(driven, removed_mm3);
    }
  }
  note_volume(driven.end_s);
}

void Carving::note_volume(double time_s) {
  auto& times = figures_.over_time;
  if (!times.empty() && time_s < times.back().time_s + time_step_s_) return;
  times.push_back({time_s, stock_.removed()});
  if (times.size() < CarvingFigures::kMaxTimes) return;
  for (std::size_t i = 0; 2 * i + 1 < times.size(); ++i) times[i] = times[2 * i + 1];
  times.resize(times.size() / 2);
  time_step_s_ *= 2.0;
}

void Carving::end(double time_s) {
  figures_.removed = stock_.removed();
  auto& times = figures_.over_time;
  if (!times.empty() && times.back().time_s >= time_s) times.pop_back();
  times.push_back({time_s, figures_.removed});
}

}  // namespace sim::stock
