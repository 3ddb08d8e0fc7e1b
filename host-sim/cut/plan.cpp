#include "host-sim/cut/plan.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "host-sim/contour/shared_work.hpp"
#include "host-sim/cut/coincident.hpp"
#include "host-sim/cut/controller_choice.hpp"
#include "host-sim/cut/controller_way.hpp"
#include "host-sim/cut/cut_precedence.hpp"
#include "host-sim/cut/cut_turn.hpp"
#include "host-sim/cut/doubled_lines.hpp"
#include "host-sim/cut/find_cuts.hpp"
#include "host-sim/cut/late_cuts.hpp"
#include "host-sim/cut/lead.hpp"
#include "host-sim/cut/open_lines.hpp"
#include "host-sim/cut/outlines.hpp"
#include "host-sim/cut/own_costs.hpp"
#include "host-sim/cut/plan_work.hpp"
#include "host-sim/cut/possible_beginnings.hpp"
#include "host-sim/cut/share_lines.hpp"
#include "host-sim/cut/start_marks.hpp"
#include "host-sim/cut/unfulfilled.hpp"
#include "planner/base/contract.hpp"

namespace sim::cut {
namespace {

using drawing::FaultKind;

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
      : work_{.drawn = drawn, .reach_mm = 2.0 * widest_kerf(layers, recipes)},
        beside_{beside},
        wish_{order} {
    work_.plan.layers = std::move(layers);
    work_.plan.recipes = std::move(recipes);
    work_.plan.curves = curves;
  }

  CutPlan make() {
    append_faults(work_.plan.warnings,
                  cut_open_on_line(work_.drawn, work_.plan.layers, work_.plan.recipes));
    std::vector<Side> sides;
    for (std::size_t i = 0; i < work_.drawn.contours.size(); ++i) {
      sides.push_back(work_.layer_of(i).settings.side);
    }
    append_faults(work_.plan.warnings, skip_coincident(work_.drawn, sides));
    work_.outlines = outlines_of(work_.drawn, sides, work_.plan.curves, work_.plan.faults);
    const LeftLines left_lines = without_doubled(work_.drawn, work_.outlines, sides);
    if (left_lines.warning) work_.plan.warnings.push_back(*left_lines.warning);
    marks_ =
        marked_starts(work_.drawn, sides, work_.outlines, work_.plan.curves, work_.plan.faults);
    for (std::size_t i = 0; i < work_.outlines.size(); ++i) {
      for (const Stroke& stroke : work_.outlines[i].strokes) {
        if (work_.outlines[i].is_beside) work_.edges.add(stroke, i);
      }
    }
    work_.edges.prepare();
    find_cuts(work_, sides, left_lines, wish_);
    put_parts_last(work_.drawn, work_.outlines, work_.plan.cuts);
    name_parts();
    share_common_lines();
    find_beginnings();
    find_own_costs();
    for (drawing::Fault& late : late_cuts(work_.drawn, work_.plan.cuts, work_.unbegun)) {
      (late.is_error() ? work_.plan.faults : work_.plan.warnings).push_back(std::move(late));
    }
    put_in_order();
    return std::move(work_.plan);
  }

 private:
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

  PlanWork work_;
  WayBeside beside_;
  const OrderWish& wish_;
  std::vector<std::optional<Place>> marks_;    ///< Marked start of each contour.
  std::vector<std::size_t> loops_of_contour_;  ///< Number of cuts of each contour.
};

/// Sets the part of each cut, and the cuts that must come before it.
void Planner::name_parts() {
  for (std::size_t i = 0; i < work_.plan.cuts.size(); ++i) {
    work_.unbegun[i].after = work_.plan.cuts[i].after;
    const std::size_t contour = work_.plan.cuts[i].contour;
    work_.unbegun[i].part = part_of(work_.drawn, work_.outlines, contour);
    if (!work_.drawn.turns.of_part.empty()) {
      work_.unbegun[i].part_turn =
          work_.drawn.turns.of_part[work_.drawn.contours[contour].entity.part];
    }
  }
}

/// Combines lines that two parts share. A line belongs to the part that is drawn first, unless this
/// part must be cut later.
void Planner::share_common_lines() {
  const auto asks = [](const UnbegunCut& cut) { return cut.settings.common_line_mm > 0.0; };
  if (std::ranges::none_of(work_.unbegun, asks)) return;
  // The order of the file does not depend on the points at which cuts begin. So one beginning for
  // each cut is sufficient.
  for (UnbegunCut& cut : work_.unbegun) cut.beginnings = {Beginning{}};
  const auto drawn = usual_order(work_.unbegun, wish_, order::OrderMethod::kFile);
  std::vector<std::size_t> ranks(work_.unbegun.size());
  for (std::size_t i = 0; i < ranks.size(); ++i) ranks[drawn[i].cut] = i;
  share_lines(work_.plan, work_.unbegun, ranks);
}

void Planner::find_beginnings() {
  // Greatest number of beginnings of all cuts together. It bounds the time of the search for them.
  constexpr std::size_t kBeginnings = 400'000;
  constexpr std::size_t kFewest = 4;
  constexpr std::size_t kUsual = 16;
  loops_of_contour_.assign(work_.outlines.size(), 0);
  for (const Cut& cut : work_.plan.cuts) ++loops_of_contour_[cut.contour];
  const std::size_t share = kBeginnings / std::max<std::size_t>(work_.plan.cuts.size(), 1);
  const std::size_t count = std::clamp(share, kFewest, kUsual);
  share_work(work_.plan.cuts.size(), [&] {
    return [&](std::size_t i) {
      const std::size_t contour = work_.plan.cuts[i].contour;
      find_possible_beginnings(work_.unbegun[i],
                               work_.outlines[contour],
                               work_.room_of(contour),
                               {.is_planned_here = beside_ == WayBeside::kHere,
                                .mark = marks_[contour],
                                .count = count});
    };
  });
  for (std::size_t i = 0; i < work_.plan.cuts.size(); ++i) {
    const std::size_t contour = work_.plan.cuts[i].contour;
    if (work_.unbegun[i].is_open && marks_[contour]) {
      work_.plan.warnings.push_back({FaultKind::kTooSmall,
                                     work_.drawn.contours[contour].entity,
                                     *marks_[contour],
                                     "begins in the cut of the adjacent part, not at its mark",
                                     "give it its own lines with common-line=0 for its layer"});
    }
    const bool is_beside = work_.outlines[contour].is_beside;
    if (is_beside && beside_ == WayBeside::kOnController && reason_against_controller(i).empty()) {
      keep_what_the_controller_finds(
          work_.unbegun[i], work_.outlines[contour], work_.room_of(contour));
    }
  }
}

std::string Planner::reason_against_controller(std::size_t cut) const {
  const std::size_t loops = loops_of_contour_[work_.plan.cuts[cut].contour];
  return cut::reason_against_controller(work_.unbegun[cut], work_.plan.cuts[cut].is_hole, loops);
}

void Planner::put_in_order() {
  work_.plan.order.wish = wish_;
  work_.plan.order.wish.progress = {};
  if (work_.plan.cuts.empty()) return;
  const ChosenOrder chosen = choose_order(work_.unbegun, wish_, work_.edges);
  const std::vector<std::size_t> turns = numbered(turns_of(work_.unbegun, wish_.grouping));
  for (std::size_t i = 0; i < turns.size(); ++i) work_.plan.cuts[i].turn = turns[i];
  std::vector<std::size_t> number(work_.plan.cuts.size());
  for (std::size_t i = 0; i < chosen.cuts.size(); ++i) number[chosen.cuts[i].cut] = i;
  std::vector<Cut> cuts;
  for (const OrderedCut& ordered : chosen.cuts) {
    Cut& cut = cuts.emplace_back(std::move(work_.plan.cuts[ordered.cut]));
    begin(cut, work_.unbegun[ordered.cut], ordered.beginning);
    if (beside_ == WayBeside::kOnController && work_.outlines[cut.contour].is_beside) {
      leave_to_controller(cut, ordered.cut);
    }
    for (std::size_t& before : cut.after) {
      before = number[before];
      CNC_ASSERT(before + 1 < cuts.size());
    }
  }
  work_.plan.cuts = std::move(cuts);
  work_.plan.order.is_proven = chosen.is_proven;
  work_.plan.order.listed = chosen.listed;
  work_.plan.order.straight = rapids_of(chosen.cuts, work_.unbegun, wish_);
  work_.plan.order.rapids = work_.plan.order.straight;
  const auto usual = [this](order::OrderMethod method) {
    return rapids_of(usual_order(work_.unbegun, wish_, method), work_.unbegun, wish_);
  };
  work_.plan.order.file = usual(order::OrderMethod::kFile);
  work_.plan.order.nearest = usual(order::OrderMethod::kNearest);
}

/// Finds the own cost of each beginning of the cuts, if a search minimises time.
void Planner::find_own_costs() {
  const bool is_searched =
      wish_.method == order::OrderMethod::kOurs || wish_.method == order::OrderMethod::kExact;
  if (wish_.cost != OrderCost::kTime || !is_searched) return;
  OwnCosts costs{wish_};
  for (std::size_t i = 0; i < work_.plan.cuts.size(); ++i) {
    const Cut& cut = work_.plan.cuts[i];
    costs.find(work_.unbegun[i], work_.layer_of(cut.contour), [&](const Beginning& beginning) {
      return begun(cut, work_.unbegun[i], beginning).strokes;
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
  if (work_.outlines[cut.contour].is_beside) {
    led = with_leads(unbegun.path,
                     unbegun.settings,
                     tabs_of(cut, unbegun),
                     work_.room_of(cut.contour),
                     beginning);
  } else {
    led.strokes = unbegun.path.begun_at(beginning.way_mm);
  }
  if (beginning.is_backwards) turn_round(led.strokes);
  return led;
}

void Planner::begin(Cut& cut, const UnbegunCut& unbegun, const Beginning& beginning) {
  LedCut led = begun(cut, unbegun, beginning);
  if (work_.outlines[cut.contour].is_beside) {
    append_faults(work_.plan.warnings,
                  unfulfilled(led,
                              unbegun.settings,
                              work_.drawn.contours[cut.contour].entity,
                              tabs_of(cut, unbegun)));
  }
  cut.strokes = std::move(led.strokes);
}

/// Gives a cut the strokes for a controller that computes the compensated path. If the controller
/// cannot compute it, the cut keeps its own path, with a warning.
void Planner::leave_to_controller(Cut& cut, std::size_t number) {
  ControllerWay way;
  way.reason = reason_against_controller(number);
  if (way.reason.empty()) {
    way = controller_way(work_.outlines[cut.contour].strokes,
                         cut.strokes,
                         work_.layer_of(cut.contour).settings,
                         work_.room_of(cut.contour));
  }
  cut.programmed = std::move(way.strokes);
  if (way.reason.empty()) return;
  work_.plan.warnings.push_back({FaultKind::kTooSmall,
                                 work_.drawn.contours[cut.contour].entity,
                                 cut.start(),
                                 "is not offset by the controller: " + way.reason,
                                 "its path is offset by the planned kerf, whatever the overrides"});
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
