#include "host-sim/cut/find_cuts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <numbers>
#include <set>
#include <utility>

#include "host-sim/cut/corner.hpp"
#include "host-sim/cut/fill_area.hpp"
#include "host-sim/cut/fill_paths.hpp"
#include "host-sim/cut/kerf_faults.hpp"
#include "host-sim/cut/paths_beside.hpp"
#include "host-sim/cut/unfulfilled.hpp"

namespace sim::cut {
namespace {

using drawing::FaultKind;

/// Removes leads, overcut, tabs and the treatment of corners from the settings.
void leave_plain(LayerSettings& settings) {
  settings.lead_in = settings.lead_out = {};
  settings.overcut_mm = 0.0;
  settings.tabs = 0;
  settings.corner_loop_mm = settings.corner_dwell_s = 0.0;
  settings.start = StartAt::kUsual;
}

/// Finds the cuts of all contours of a plan.
class CutFinder {
 public:
  CutFinder(PlanWork& work, const LeftLines& left_lines, const OrderWish& wish)
      : work_{work}, left_lines_{left_lines}, wish_{wish} {}

  void find(const std::vector<Side>& sides) {
    cut_contours(sides);
    fill_areas(sides);
  }

 private:
  [[nodiscard]] bool may_share(std::size_t a, std::size_t b) const;
  void cut_contours(const std::vector<Side>& sides);
  void cut_beside(std::size_t i, const PathBeside& path);
  void vanish(std::size_t i);
  void cut_along(std::size_t i);
  void fill_areas(const std::vector<Side>& sides);
  void fill_layer(const std::vector<std::size_t>& contours);
  void add_cut(std::size_t i, const std::vector<Stroke>& loop);
  void add_middle(std::size_t i, const std::vector<Stroke>& row);

  PlanWork& work_;
  const LeftLines& left_lines_;
  const OrderWish& wish_;
  /// Numbers of the layers that already have the warning about cuts on the line.
  std::set<std::size_t> told_layers_;
};

bool CutFinder::may_share(std::size_t a, std::size_t b) const {
  return work_.layer_of(a).settings.common_line_mm > 0.0 &&
         &work_.layer_of(a) == &work_.layer_of(b);
}

void CutFinder::cut_contours(const std::vector<Side>& sides) {
  const DrawnEdges drawn{work_.drawn,
                         work_.outlines,
                         work_.edges,
                         work_.reach_mm,
                         [this](std::size_t i) { return work_.half_kerf(i); },
                         [this](std::size_t i) { return work_.layer_of(i).settings.narrow_mm; },
                         [this](std::size_t a, std::size_t b) { return may_share(a, b); }};
  std::vector<PathBeside> paths = paths_beside(drawn, work_.plan.warnings);
  for (std::size_t i = 0; i < work_.outlines.size(); ++i) {
    if (work_.outlines[i].is_beside) cut_beside(i, std::exchange(paths[i], {}));
    if (work_.outlines[i].is_beside || work_.outlines[i].strokes.empty()) continue;
    if (sides[i] != Side::kFill) cut_along(i);
  }
}

void CutFinder::cut_beside(std::size_t i, const PathBeside& path) {
  if (path.failure) work_.plan.faults.push_back(*path.failure);
  if (path.vanishes) vanish(i);
  append_faults(work_.plan.warnings,
                rests_of(work_.drawn.contours[i].entity, path.rests, work_.half_kerf(i)));
  for (const std::vector<Stroke>& row : path.middles) add_middle(i, row);
  for (const std::vector<Stroke>& loop : path.loops) {
    add_cut(i, loop);
    work_.unbegun.back().is_on_edge = path.shares_edges;
  }
  append_faults(work_.plan.faults, path.gouges);
}

/// Reports an outline that is narrower than the kerf. A gap between contours that cross only gets a
/// warning, because the user did not draw it as a slot.
void CutFinder::vanish(std::size_t i) {
  drawing::Fault fault{FaultKind::kTooSmall,
                       work_.drawn.contours[i].entity,
                       work_.outlines[i].strokes.front().from,
                       fmt::format("is narrower than the kerf of {:.3f} mm and would vanish",
                                   2.0 * work_.half_kerf(i)),
                       "make it wider, cut it on the line with side=on, or skip its layer"};
  if (work_.layer_of(i).settings.narrow_mm < work_.half_kerf(i)) {
    fault.remedy =
        fmt::format("cut it once along its middle with --narrow {:.3f}, ", work_.half_kerf(i)) +
        fault.remedy;
  }
  const bool is_gap = work_.drawn.contours[i].is_filled && work_.outlines[i].is_hole;
  if (is_gap) fault.remedy = "it is left out";
  (is_gap ? work_.plan.warnings : work_.plan.faults).push_back(std::move(fault));
}

void CutFinder::cut_along(std::size_t i) {
  const std::size_t layer = work_.drawn.contours[i].entity.layer;
  if (told_layers_.insert(layer).second) {
    append_faults(work_.plan.warnings,
                  unfulfilled_on_line(work_.layer_of(i).settings,
                                      work_.drawn.contours[i].entity,
                                      work_.outlines[i].strokes.front().from));
  }
  LayerSettings settings = work_.layer_of(i).settings;
  settings.overcut_mm = 0.0;
  const auto add = [&](const std::vector<Stroke>& row, bool is_open) {
    work_.unbegun.push_back(
        {.path = MeasuredRow{row}, .is_open = is_open, .settings = settings, .layer = layer});
    work_.plan.cuts.push_back({.contour = i, .layer = layer});
  };
  const auto rests = left_lines_.rests.find(i);
  if (rests == left_lines_.rests.end())
    return add(work_.outlines[i].strokes, !work_.outlines[i].is_closed);
  for (const std::vector<Stroke>& row : rests->second) add(row, true);
}

/// Fills the closed contours of filled layers. Contours with the same plan are filled together.
void CutFinder::fill_areas(const std::vector<Side>& sides) {
  std::vector<std::pair<const LayerPlan*, std::vector<std::size_t>>> alike;
  for (std::size_t i = 0; i < work_.outlines.size(); ++i) {
    if (sides[i] != Side::kFill || work_.outlines[i].strokes.empty()) continue;
    const LayerPlan* const plan = &work_.layer_of(i);
    auto known = std::ranges::find(alike, plan, &decltype(alike)::value_type::first);
    if (known == alike.end()) known = alike.insert(known, {plan, {}});
    known->second.push_back(i);
  }
  for (const auto& [plan, contours] : alike) fill_layer(contours);
}

void CutFinder::fill_layer(const std::vector<std::size_t>& contours) {
  const LayerPlan& plan = work_.layer_of(contours.front());
  const FillSettings& fill = plan.settings.fill;
  const double speed_mm_s = 1.0e-3 * plan.condition.cut.speed_um_min / 60.0;
  const double overscan_mm =
      fill.overscan_mm.value_or(overscan_for(speed_mm_s, fill.angle_deg, wish_.limits));
  std::vector<std::vector<Stroke>> outlines;
  outlines.reserve(contours.size());
  for (const std::size_t i : contours) outlines.push_back(work_.outlines[i].strokes);
  for (const std::vector<std::size_t>& group : groups_by_box(outlines)) {
    std::vector<std::vector<Stroke>> area;
    area.reserve(group.size());
    for (const std::size_t member : group) area.push_back(outlines[member]);
    const std::size_t first = contours[group.front()];
    const std::size_t layer = work_.drawn.contours[first].entity.layer;
    FillPaths filled = fill_paths(area, fill, overscan_mm, work_.drawn.contours[first].entity);
    append_faults(work_.plan.faults, filled.faults);
    append_faults(work_.plan.warnings, filled.warnings);
    for (std::vector<Stroke>& path : filled.paths) {
      work_.unbegun.push_back({.path = MeasuredRow{std::move(path)},
                               .is_open = true,
                               .settings = plan.settings,
                               .layer = layer});
      work_.plan.cuts.push_back({.contour = first, .layer = layer});
    }
  }
}

void CutFinder::add_cut(std::size_t i, const std::vector<Stroke>& loop) {
  const LayerSettings& settings = work_.layer_of(i).settings;
  Cut cut{.contour = i,
          .layer = work_.drawn.contours[i].entity.layer,
          .is_hole = work_.outlines[i].is_hole,
          .area_mm2 = area_of(loop)};
  const double min_turn = settings.corner_angle_deg * std::numbers::pi / 180.0;
  for (const Corner& corner : corners_of(loop, min_turn, work_.half_kerf(i))) {
    cut.corners.push_back(corner.place);
  }
  work_.unbegun.push_back({.path = MeasuredRow{loop},
                           .settings = settings,
                           .half_kerf_mm = work_.half_kerf(i),
                           .layer = cut.layer});
  work_.plan.cuts.push_back(std::move(cut));
}

/// Adds a cut along a line in narrow waste. The cut has no leads, because there is no free space
/// for them.
void CutFinder::add_middle(std::size_t i, const std::vector<Stroke>& row) {
  UnbegunCut cut{.path = MeasuredRow{row},
                 .is_open = true,
                 .settings = work_.layer_of(i).settings,
                 .half_kerf_mm = work_.half_kerf(i),
                 .layer = work_.drawn.contours[i].entity.layer};
  leave_plain(cut.settings);
  work_.plan.cuts.push_back(
      {.contour = i, .layer = cut.layer, .is_hole = work_.outlines[i].is_hole});
  work_.unbegun.push_back(std::move(cut));
}

}  // namespace

void find_cuts(PlanWork& work,
               const std::vector<Side>& sides,
               const LeftLines& left_lines,
               const OrderWish& wish) {
  CutFinder{work, left_lines, wish}.find(sides);
}

}  // namespace sim::cut
