#include "host-sim/cut/plan.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <set>
#include <utility>

#include "host-sim/contour/shared_work.hpp"
#include "host-sim/cut/clearance.hpp"
#include "host-sim/cut/coincident.hpp"
#include "host-sim/cut/controller_choice.hpp"
#include "host-sim/cut/controller_way.hpp"
#include "host-sim/cut/cut_precedence.hpp"
#include "host-sim/cut/cut_turn.hpp"
#include "host-sim/cut/doubled_lines.hpp"
#include "host-sim/cut/fill_area.hpp"
#include "host-sim/cut/fill_paths.hpp"
#include "host-sim/cut/kerf_faults.hpp"
#include "host-sim/cut/late_cuts.hpp"
#include "host-sim/cut/lead.hpp"
#include "host-sim/cut/open_lines.hpp"
#include "host-sim/cut/outlines.hpp"
#include "host-sim/cut/own_costs.hpp"
#include "host-sim/cut/paths_beside.hpp"
#include "host-sim/cut/possible_beginnings.hpp"
#include "host-sim/cut/share_lines.hpp"
#include "host-sim/cut/start_marks.hpp"
#include "host-sim/cut/unfulfilled.hpp"
#include "planner/base/contract.hpp"

namespace sim::cut {
namespace {

using drawing::FaultKind;

void append(std::vector<drawing::Fault>& faults, const std::vector<drawing::Fault>& more) {
  faults.insert(faults.end(), more.begin(), more.end());
}

/// Removes leads, overcut, tabs and the treatment of corners from the settings.
void leave_plain(LayerSettings& settings) {
  settings.lead_in = settings.lead_out = {};
  settings.overcut_mm = 0.0;
  settings.tabs = 0;
  settings.corner_loop_mm = settings.corner_dwell_s = 0.0;
  settings.start = StartAt::kUsual;
}

double widest_kerf(const std::vector<LayerPlan>& layers, const Recipes& recipes) {
  double widest = 1.0e-3;
  for (const LayerPlan& layer : layers) widest = std::max(widest, layer.condition.kerf_mm);
  for (const LayerPlan& plan : recipes.plans) widest = std::max(widest, plan.condition.kerf_mm);
  return widest;
}

/// Makes the plan of one drawing: first the cuts, then their order and beginnings.
class Planner {
 public:
  Planner(const drawing::Drawing& drawn,
          std::vector<LayerPlan> layers,
          const OutlineOptions& curves,
          WayBeside beside,
          Recipes recipes,
          const OrderWish& order)
      : drawn_{drawn},
        beside_{beside},
        wish_{order},
        reach_mm_{2.0 * widest_kerf(layers, recipes)},
        edges_{reach_mm_} {
    plan_.layers = std::move(layers);
    plan_.recipes = std::move(recipes);
    plan_.curves = curves;
  }

  CutPlan make() {
    append(plan_.warnings, cut_open_on_line(drawn_, plan_.layers, plan_.recipes));
    std::vector<Side> sides;
    for (std::size_t i = 0; i < drawn_.contours.size(); ++i) {
      sides.push_back(layer_of(i).settings.side);
    }
    append(plan_.warnings, skip_coincident(drawn_, sides));
    outlines_ = outlines_of(drawn_, sides, plan_.curves, plan_.faults);
    left_lines_ = without_doubled(drawn_, outlines_, sides);
    if (left_lines_.warning) plan_.warnings.push_back(*left_lines_.warning);
    marks_ = marked_starts(drawn_, sides, outlines_, plan_.curves, plan_.faults);
    for (std::size_t i = 0; i < outlines_.size(); ++i) {
      for (const Stroke& stroke : outlines_[i].strokes) {
        if (outlines_[i].is_beside) edges_.add(stroke, i);
      }
    }
    edges_.prepare();
    cut_contours(sides);
    fill_areas(sides);
    put_parts_last(drawn_, outlines_, plan_.cuts);
    name_parts();
    share_common_lines();
    find_beginnings();
    find_own_costs();
    for (drawing::Fault& late : late_cuts(drawn_, plan_.cuts, unbegun_)) {
      (late.is_error() ? plan_.faults : plan_.warnings).push_back(std::move(late));
    }
    put_in_order();
    return std::move(plan_);
  }

 private:
  [[nodiscard]] const LayerPlan& layer_of(std::size_t contour) const {
    return plan_.recipes.of(contour, plan_.layers[drawn_.contours[contour].entity.layer]);
  }
  [[nodiscard]] double half_kerf(std::size_t contour) const {
    return 0.5 * layer_of(contour).condition.kerf_mm;
  }
  [[nodiscard]] LeadRoom room_of(std::size_t contour) const { return {edges_, half_kerf(contour)}; }
  [[nodiscard]] bool may_share(std::size_t a, std::size_t b) const;
  void cut_contours(const std::vector<Side>& sides);
  void cut_beside(std::size_t i, const PathBeside& path);
  void vanish(std::size_t i);
  void cut_along(std::size_t i);
  void fill_areas(const std::vector<Side>& sides);
  void fill_layer(const std::vector<std::size_t>& contours);
  void add_cut(std::size_t i, const std::vector<Stroke>& loop);
  void add_middle(std::size_t i, const std::vector<Stroke>& row);
  void name_parts();
  void share_common_lines();
  void find_beginnings();
  [[nodiscard]] std::string reason_against_controller(std::size_t cut) const;
  void put_in_order();
  void find_own_costs();
  [[nodiscard]] static unsigned tabs_of(const Cut& cut, const UnbegunCut& unbegun);
  [[nodiscard]] LedCut begun(const Cut& cut,
                             const UnbegunCut& unbegun,
                             const Beginning& beginning) const;
  void begin(Cut& cut, const UnbegunCut& unbegun, const Beginning& beginning);
  void leave_to_controller(Cut& cut, std::size_t number);

  const drawing::Drawing& drawn_;
  WayBeside beside_;
  const OrderWish& wish_;
  /// The plan. Until the order is chosen, its cuts have no strokes and are in the order of the
  /// drawing.
  CutPlan plan_;
  std::vector<UnbegunCut> unbegun_;  ///< One unbegun cut for each cut of the plan.
  std::vector<Outline> outlines_;    ///< Outline of each contour; empty if the contour is not cut.
  LeftLines left_lines_;
  std::vector<std::optional<Place>> marks_;    ///< Marked start of each contour.
  std::vector<std::size_t> loops_of_contour_;  ///< Number of cuts of each contour.
  /// Distance within which edges matter, and which searches cover: twice the widest kerf.
  double reach_mm_;
  Clearance edges_;
  /// Numbers of the layers that already have the warning about cuts on the line.
  std::set<std::size_t> told_layers_;
};

bool Planner::may_share(std::size_t a, std::size_t b) const {
  return layer_of(a).settings.common_line_mm > 0.0 && &layer_of(a) == &layer_of(b);
}

void Planner::cut_contours(const std::vector<Side>& sides) {
  const DrawnEdges drawn{drawn_,
                         outlines_,
                         edges_,
                         reach_mm_,
                         [this](std::size_t i) { return half_kerf(i); },
                         [this](std::size_t i) { return layer_of(i).settings.narrow_mm; },
                         [this](std::size_t a, std::size_t b) { return may_share(a, b); }};
  std::vector<PathBeside> paths = paths_beside(drawn, plan_.warnings);
  for (std::size_t i = 0; i < outlines_.size(); ++i) {
    if (outlines_[i].is_beside) cut_beside(i, std::exchange(paths[i], {}));
    if (outlines_[i].is_beside || outlines_[i].strokes.empty()) continue;
    if (sides[i] != Side::kFill) cut_along(i);
  }
}

void Planner::cut_beside(std::size_t i, const PathBeside& path) {
  if (path.failure) plan_.faults.push_back(*path.failure);
  if (path.vanishes) vanish(i);
  append(plan_.warnings, rests_of(drawn_.contours[i].entity, path.rests, half_kerf(i)));
  for (const std::vector<Stroke>& row : path.middles) add_middle(i, row);
  for (const std::vector<Stroke>& loop : path.loops) {
    add_cut(i, loop);
    unbegun_.back().is_on_edge = path.shares_edges;
  }
  append(plan_.faults, path.gouges);
}

/// Reports an outline that is narrower than the kerf. A gap between contours that cross is not a
/// slot that the user drew, so it only gets a warning.
void Planner::vanish(std::size_t i) {
  drawing::Fault fault{
      FaultKind::kTooSmall,
      drawn_.contours[i].entity,
      outlines_[i].strokes.front().from,
      fmt::format("is narrower than the kerf of {:.3f} mm and would vanish", 2.0 * half_kerf(i)),
      "make it wider, cut it on the line with side=on, or skip its layer"};
  if (layer_of(i).settings.narrow_mm < half_kerf(i)) {
    fault.remedy =
        fmt::format("cut it once along its middle with --narrow {:.3f}, ", half_kerf(i)) +
        fault.remedy;
  }
  const bool is_gap = drawn_.contours[i].is_filled && outlines_[i].is_hole;
  if (is_gap) fault.remedy = "it is left out";
  (is_gap ? plan_.warnings : plan_.faults).push_back(std::move(fault));
}

void Planner::cut_along(std::size_t i) {
  const std::size_t layer = drawn_.contours[i].entity.layer;
  if (told_layers_.insert(layer).second) {
    append(plan_.warnings,
           unfulfilled_on_line(
               layer_of(i).settings, drawn_.contours[i].entity, outlines_[i].strokes.front().from));
  }
  LayerSettings settings = layer_of(i).settings;
  settings.overcut_mm = 0.0;
  const auto add = [&](const std::vector<Stroke>& row, bool is_open) {
    unbegun_.push_back(
        {.path = MeasuredRow{row}, .is_open = is_open, .settings = settings, .layer = layer});
    plan_.cuts.push_back({.contour = i, .layer = layer});
  };
  const auto rests = left_lines_.rests.find(i);
  if (rests == left_lines_.rests.end()) return add(outlines_[i].strokes, !outlines_[i].is_closed);
  for (const std::vector<Stroke>& row : rests->second) add(row, true);
}

/// Fills the closed contours of filled layers. Contours with the same plan are filled together.
void Planner::fill_areas(const std::vector<Side>& sides) {
  std::vector<std::pair<const LayerPlan*, std::vector<std::size_t>>> alike;
  for (std::size_t i = 0; i < outlines_.size(); ++i) {
    if (sides[i] != Side::kFill || outlines_[i].strokes.empty()) continue;
    const LayerPlan* const plan = &layer_of(i);
    auto known = std::ranges::find(alike, plan, &decltype(alike)::value_type::first);
    if (known == alike.end()) known = alike.insert(known, {plan, {}});
    known->second.push_back(i);
  }
  for (const auto& [plan, contours] : alike) fill_layer(contours);
}

void Planner::fill_layer(const std::vector<std::size_t>& contours) {
  const LayerPlan& plan = layer_of(contours.front());
  const FillSettings& fill = plan.settings.fill;
  const double speed_mm_s = 1.0e-3 * plan.condition.cut.speed_um_min / 60.0;
  const double overscan_mm =
      fill.overscan_mm.value_or(overscan_for(speed_mm_s, fill.angle_deg, wish_.limits));
  std::vector<std::vector<Stroke>> outlines;
  outlines.reserve(contours.size());
  for (const std::size_t i : contours) outlines.push_back(outlines_[i].strokes);
  for (const std::vector<std::size_t>& group : groups_by_box(outlines)) {
    std::vector<std::vector<Stroke>> area;
    area.reserve(group.size());
    for (const std::size_t member : group) area.push_back(outlines[member]);
    const std::size_t first = contours[group.front()];
    const std::size_t layer = drawn_.contours[first].entity.layer;
    FillPaths filled = fill_paths(area, fill, overscan_mm, drawn_.contours[first].entity);
    append(plan_.faults, filled.faults);
    append(plan_.warnings, filled.warnings);
    for (std::vector<Stroke>& path : filled.paths) {
      unbegun_.push_back({.path = MeasuredRow{std::move(path)},
                          .is_open = true,
                          .settings = plan.settings,
                          .layer = layer});
      plan_.cuts.push_back({.contour = first, .layer = layer});
    }
  }
}

void Planner::add_cut(std::size_t i, const std::vector<Stroke>& loop) {
  const LayerSettings& settings = layer_of(i).settings;
  Cut cut{.contour = i,
          .layer = drawn_.contours[i].entity.layer,
          .is_hole = outlines_[i].is_hole,
          .area_mm2 = area_of(loop)};
  const double min_turn = settings.corner_angle_deg * std::numbers::pi / 180.0;
  for (const Corner& corner : corners_of(loop, min_turn, half_kerf(i))) {
    cut.corners.push_back(corner.place);
  }
  unbegun_.push_back({.path = MeasuredRow{loop},
                      .settings = settings,
                      .half_kerf_mm = half_kerf(i),
                      .layer = cut.layer});
  plan_.cuts.push_back(std::move(cut));
}

/// Adds a cut along a line in narrow waste. The cut has no leads, because there is no free space
/// for them.
void Planner::add_middle(std::size_t i, const std::vector<Stroke>& row) {
  UnbegunCut cut{.path = MeasuredRow{row},
                 .is_open = true,
                 .settings = layer_of(i).settings,
                 .half_kerf_mm = half_kerf(i),
                 .layer = drawn_.contours[i].entity.layer};
  leave_plain(cut.settings);
  plan_.cuts.push_back({.contour = i, .layer = cut.layer, .is_hole = outlines_[i].is_hole});
  unbegun_.push_back(std::move(cut));
}

/// Sets the part of each cut, and the cuts that must come before it.
void Planner::name_parts() {
  for (std::size_t i = 0; i < plan_.cuts.size(); ++i) {
    unbegun_[i].after = plan_.cuts[i].after;
    const std::size_t contour = plan_.cuts[i].contour;
    unbegun_[i].part = part_of(drawn_, outlines_, contour);
    if (!drawn_.turns.of_part.empty()) {
      unbegun_[i].part_turn = drawn_.turns.of_part[drawn_.contours[contour].entity.part];
    }
  }
}

/// Combines lines that two parts share. A line belongs to the part that is drawn first, unless this
/// part must be cut later.
void Planner::share_common_lines() {
  const auto asks = [](const UnbegunCut& cut) { return cut.settings.common_line_mm > 0.0; };
  if (std::ranges::none_of(unbegun_, asks)) return;
  // The points of the beginnings do not affect the order of the file, so one for each cut suffices.
  for (UnbegunCut& cut : unbegun_) cut.beginnings = {Beginning{}};
  const auto drawn = usual_order(unbegun_, wish_, order::OrderMethod::kFile);
  std::vector<std::size_t> ranks(unbegun_.size());
  for (std::size_t i = 0; i < ranks.size(); ++i) ranks[drawn[i].cut] = i;
  share_lines(plan_, unbegun_, ranks);
}

void Planner::find_beginnings() {
  // Greatest number of beginnings of all cuts together. It bounds the time of the search for them.
  constexpr std::size_t kBeginnings = 400'000;
  constexpr std::size_t kFewest = 4;
  constexpr std::size_t kUsual = 16;
  loops_of_contour_.assign(outlines_.size(), 0);
  for (const Cut& cut : plan_.cuts) ++loops_of_contour_[cut.contour];
  const std::size_t share = kBeginnings / std::max<std::size_t>(plan_.cuts.size(), 1);
  const std::size_t count = std::clamp(share, kFewest, kUsual);
  share_work(plan_.cuts.size(), [&] {
    return [&](std::size_t i) {
      const std::size_t contour = plan_.cuts[i].contour;
      find_possible_beginnings(unbegun_[i],
                               outlines_[contour],
                               room_of(contour),
                               {.is_planned_here = beside_ == WayBeside::kHere,
                                .mark = marks_[contour],
                                .count = count});
    };
  });
  for (std::size_t i = 0; i < plan_.cuts.size(); ++i) {
    const std::size_t contour = plan_.cuts[i].contour;
    if (unbegun_[i].is_open && marks_[contour]) {
      plan_.warnings.push_back({FaultKind::kTooSmall,
                                drawn_.contours[contour].entity,
                                *marks_[contour],
                                "begins in the cut of the adjacent part, not at its mark",
                                "give it its own lines with common-line=0 for its layer"});
    }
    const bool is_beside = outlines_[contour].is_beside;
    if (is_beside && beside_ == WayBeside::kOnController && reason_against_controller(i).empty()) {
      keep_what_the_controller_finds(unbegun_[i], outlines_[contour], room_of(contour));
    }
  }
}

std::string Planner::reason_against_controller(std::size_t cut) const {
  const std::size_t loops = loops_of_contour_[plan_.cuts[cut].contour];
  return cut::reason_against_controller(unbegun_[cut], plan_.cuts[cut].is_hole, loops);
}

void Planner::put_in_order() {
  plan_.order.wish = wish_;
  plan_.order.wish.progress = {};
  if (plan_.cuts.empty()) return;
  const ChosenOrder chosen = choose_order(unbegun_, wish_, edges_);
  const std::vector<std::size_t> turns = numbered(turns_of(unbegun_, wish_.grouping));
  for (std::size_t i = 0; i < turns.size(); ++i) plan_.cuts[i].turn = turns[i];
  std::vector<std::size_t> number(plan_.cuts.size());
  for (std::size_t i = 0; i < chosen.cuts.size(); ++i) number[chosen.cuts[i].cut] = i;
  std::vector<Cut> cuts;
  for (const OrderedCut& ordered : chosen.cuts) {
    Cut& cut = cuts.emplace_back(std::move(plan_.cuts[ordered.cut]));
    begin(cut, unbegun_[ordered.cut], ordered.beginning);
    if (beside_ == WayBeside::kOnController && outlines_[cut.contour].is_beside) {
      leave_to_controller(cut, ordered.cut);
    }
    for (std::size_t& before : cut.after) {
      before = number[before];
      CNC_ASSERT(before + 1 < cuts.size());
    }
  }
  plan_.cuts = std::move(cuts);
  plan_.order.is_proven = chosen.is_proven;
  plan_.order.listed = chosen.listed;
  plan_.order.straight = rapids_of(chosen.cuts, unbegun_, wish_);
  plan_.order.rapids = plan_.order.straight;
  const auto usual = [this](order::OrderMethod method) {
    return rapids_of(usual_order(unbegun_, wish_, method), unbegun_, wish_);
  };
  plan_.order.file = usual(order::OrderMethod::kFile);
  plan_.order.nearest = usual(order::OrderMethod::kNearest);
}

/// Finds the own cost of each beginning of the cuts, if a search minimises time.
void Planner::find_own_costs() {
  const bool is_searched =
      wish_.method == order::OrderMethod::kOurs || wish_.method == order::OrderMethod::kExact;
  if (wish_.cost != OrderCost::kTime || !is_searched) return;
  OwnCosts costs{wish_};
  for (std::size_t i = 0; i < plan_.cuts.size(); ++i) {
    const Cut& cut = plan_.cuts[i];
    costs.find(unbegun_[i], layer_of(cut.contour), [&](const Beginning& beginning) {
      return begun(cut, unbegun_[i], beginning).strokes;
    });
  }
}

/// Returns the number of tabs of a cut. Only a part has tabs, because it would fall out; a hole has
/// none.
unsigned Planner::tabs_of(const Cut& cut, const UnbegunCut& unbegun) {
  return cut.area_mm2 > 0.0 ? unbegun.settings.tabs : 0;
}

LedCut Planner::begun(const Cut& cut, const UnbegunCut& unbegun, const Beginning& beginning) const {
  LedCut led;
  if (outlines_[cut.contour].is_beside) {
    led = with_leads(
        unbegun.path, unbegun.settings, tabs_of(cut, unbegun), room_of(cut.contour), beginning);
  } else {
    led.strokes = unbegun.path.begun_at(beginning.way_mm);
  }
  if (beginning.is_backwards) turn_round(led.strokes);
  return led;
}

void Planner::begin(Cut& cut, const UnbegunCut& unbegun, const Beginning& beginning) {
  LedCut led = begun(cut, unbegun, beginning);
  if (outlines_[cut.contour].is_beside) {
    append(plan_.warnings,
           unfulfilled(
               led, unbegun.settings, drawn_.contours[cut.contour].entity, tabs_of(cut, unbegun)));
  }
  cut.strokes = std::move(led.strokes);
}

/// Gives a cut the strokes for a controller that computes the compensated path. If the controller
/// cannot compute it, the cut keeps its own path, with a warning.
void Planner::leave_to_controller(Cut& cut, std::size_t number) {
  ControllerWay way;
  way.reason = reason_against_controller(number);
  if (way.reason.empty()) {
    way = controller_way(outlines_[cut.contour].strokes,
                         cut.strokes,
                         layer_of(cut.contour).settings,
                         room_of(cut.contour));
  }
  cut.programmed = std::move(way.strokes);
  if (way.reason.empty()) return;
  plan_.warnings.push_back({FaultKind::kTooSmall,
                            drawn_.contours[cut.contour].entity,
                            cut.start(),
                            "is not left to the controller: " + way.reason,
                            "its path has the planned kerf, which overrides do not change"});
}

}  // namespace

CutPlan plan_cuts(const drawing::Drawing& drawn,
                  std::vector<LayerPlan> layers,
                  const OutlineOptions& curves,
                  WayBeside beside,
                  Recipes recipes,
                  const OrderWish& order) {
  CNC_ASSERT(layers.size() == drawn.layers.size());
  return Planner{drawn, std::move(layers), curves, beside, std::move(recipes), order}.make();
}

}  // namespace sim::cut
