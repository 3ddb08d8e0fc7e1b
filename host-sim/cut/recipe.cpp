#include "host-sim/cut/recipe.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <stdexcept>

#include "host-sim/cut/contour_size.hpp"
#include "host-sim/knowledge/experiment.hpp"

namespace sim::cut {
namespace {

using drawing::DrawnContour;

bool holds(Relation relation, double value, double bound) {
  switch (relation) {
    case Relation::kLess:
      return value < bound;
    case Relation::kAtMost:
      return value <= bound;
    case Relation::kGreater:
      return value > bound;
    case Relation::kAtLeast:
      return value >= bound;
  }
  return false;
}

/// Applies rules to one drawing. Contours of one layer to which the same rules apply share a plan.
class RuleApplier {
 public:
  RuleApplier(const std::vector<ShopRule>& rules,
              const drawing::Drawing& drawn,
              const std::vector<LayerPlan>& layers,
              double thickness_mm,
              double mark_share,
              const ChooseCondition& choose)
      : drawn_{drawn},
        layers_{layers},
        thickness_mm_{thickness_mm},
        mark_share_{mark_share},
        choose_{choose} {
    for (const ShopRule& rule : rules) recipes_.applied.push_back({rule});
  }

  Recipes apply() && {
    if (recipes_.applied.empty()) return {};
    recipes_.by_contour.assign(drawn_.contours.size(), Recipes::kOfLayer);
    for (std::size_t i = 0; i < drawn_.contours.size(); ++i) {
      if (!is_driven(layer_of(i).settings.side)) continue;
      const std::vector<std::size_t> rules = rules_for(i);
      for (const std::size_t rule : rules) recipes_.applied[rule].contours.push_back(i);
      if (!rules.empty()) recipes_.by_contour[i] = plan_for(drawn_.contours[i].entity.layer, rules);
    }
    return std::move(recipes_);
  }

 private:
  [[nodiscard]] const LayerPlan& layer_of(std::size_t contour) const {
    return layers_[drawn_.contours[contour].entity.layer];
  }

  std::vector<std::size_t> rules_for(std::size_t contour) const {
    std::vector<std::size_t> rules;
    std::optional<double> diameter;
    for (std::size_t k = 0; k < recipes_.applied.size(); ++k) {
      const ShopRule& rule = recipes_.applied[k].rule;
      const bool applies = is_of_kind(contour, rule.kind) &&
                           std::ranges::all_of(rule.comparisons, [&](const Comparison& comparison) {
                             return compares(drawn_.contours[contour], comparison, diameter);
                           });
      if (applies) rules.push_back(k);
    }
    return rules;
  }

  [[nodiscard]] bool is_of_kind(std::size_t contour, ContourKind kind) const {
    const DrawnContour& drawn = drawn_.contours[contour];
    if (kind == ContourKind::kAny) return true;
    if (kind == ContourKind::kOpen) return !drawn.closed;
    if (!drawn.closed || layer_of(contour).settings.side != Side::kWaste) return false;
    std::size_t depth = 0;
    for (auto p = drawn.parent; p; p = drawn_.contours[*p].parent) {
      if (layer_of(*p).settings.side == Side::kWaste) ++depth;
    }
    return (depth % 2 == 1) == (kind == ContourKind::kHole);
  }

  [[nodiscard]] bool compares(const DrawnContour& contour,
                              const Comparison& comparison,
                              std::optional<double>& diameter) const {
    const double bound =
        comparison.of_thickness ? comparison.bound * thickness_mm_ : comparison.bound;
    switch (comparison.quantity) {
      case Quantity::kDiameter:
        if (!contour.closed) return false;
        if (!diameter) diameter = diameter_of(contour);
        return holds(comparison.relation, *diameter, bound);
      case Quantity::kPerimeter:
        return holds(comparison.relation, contour.length_mm, bound);
      case Quantity::kArea:
        return contour.closed && holds(comparison.relation, std::abs(contour.area_mm2), bound);
      case Quantity::kThickness:
        return holds(comparison.relation, thickness_mm_, bound);
    }
    return false;
  }

  std::uint32_t plan_for(std::size_t layer, const std::vector<std::size_t>& rules) {
    const auto [known, is_new] =
        plans_.try_emplace({layer, rules}, static_cast<std::uint32_t>(recipes_.plans.size()));
    if (is_new) recipes_.plans.push_back(make_plan(layers_[layer], rules));
    return known->second;
  }

  LayerPlan make_plan(const LayerPlan& layer, const std::vector<std::size_t>& rules) const {
    LayerPlan plan = layer;
    for (const std::size_t rule : rules) change(plan, layer, rule);
    if (!is_driven(plan.settings.side)) return plan;
    if (is_engraved(plan.settings.side)) return marked(plan, layer);
    try {
      plan.condition = choose_(plan.settings);
    } catch (const std::invalid_argument& error) {
      const ShopRule& last = recipes_.applied[rules.back()].rule;
      throw std::invalid_argument(
          fmt::format("{}: \"{}\": {}", last.place, last.text, error.what()));
    }
    return plan;
  }

  void change(LayerPlan& plan, const LayerPlan& layer, std::size_t index) const {
    const ShopRule& rule = recipes_.applied[index].rule;
    if (rule.action == RuleAction::kSkip) plan.settings.side = Side::kSkip;
    if (rule.action == RuleAction::kMark) {
      // A mark has neither leads nor tabs. With the default settings, no warning reports the leads
      // and tabs of the layer as missing.
      plan.settings = {.air = plan.settings.air};
      plan.settings.side = Side::kMark;
    }
    for (const RuleChange& each : rule.changes) {
      if (each.percent == 0.0) {
        set(plan.settings, each.key, each.value);
      } else if (each.key == "feed") {
        plan.settings.feed_mm_min =
            0.01 * each.percent * from_thousandths(layer.condition.cut.speed_um_min);
      } else {
        plan.settings.power_w =
            0.01 * each.percent * from_thousandths(layer.condition.cut.power_mw);
      }
    }
  }

  [[nodiscard]] LayerPlan marked(LayerPlan plan, const LayerPlan& layer) const {
    const auto given = [](const std::optional<double>& value) {
      return value ? std::optional{to_thousandths(*value)} : std::nullopt;
    };
    const bool is_cut = !is_engraved(layer.settings.side);
    plan.condition = engraving(layer.condition,
                               is_cut ? mark_share_ : 1.0,
                               given(plan.settings.power_w),
                               given(plan.settings.feed_mm_min));
    return plan;
  }

  const drawing::Drawing& drawn_;
  const std::vector<LayerPlan>& layers_;
  double thickness_mm_;
  double mark_share_;
  const ChooseCondition& choose_;
  Recipes recipes_;
  std::map<std::pair<std::size_t, std::vector<std::size_t>>, std::uint32_t> plans_;
};

std::string how(const LayerPlan& plan) {
  if (plan.settings.side == Side::kSkip) return "skipped";
  const std::string cut = fmt::format("{:g} W at {:g} mm/min",
                                      from_thousandths(plan.condition.cut.power_mw),
                                      from_thousandths(plan.condition.cut.speed_um_min));
  if (plan.settings.side == Side::kOn) return "on the line, " + cut;
  return fmt::format("{}, {}", cut, width_text(plan));
}

}  // namespace

std::string width_text(const LayerPlan& plan) {
  if (plan.settings.side == Side::kFill) return "filled";
  if (plan.settings.side == Side::kImage) return "burnt as a picture";
  if (plan.settings.side == Side::kMark) return plan.settings.is_scored ? "scored" : "engraved";
  return fmt::format("kerf {:.4f} mm", plan.condition.kerf_mm);
}

Recipes apply_rules(const std::vector<ShopRule>& rules,
                    const drawing::Drawing& drawn,
                    const std::vector<LayerPlan>& layers,
                    double thickness_mm,
                    double mark_share,
                    const ChooseCondition& choose) {
  return RuleApplier{rules, drawn, layers, thickness_mm, mark_share, choose}.apply();
}

std::vector<std::string> lines_of(const Recipes& recipes) {
  std::vector<std::string> lines;
  for (const AppliedRule& applied : recipes.applied) {
    const std::size_t count = applied.contours.size();
    std::string line =
        fmt::format("rule \"{}\": {} contour{}", applied.rule.text, count, count == 1 ? "" : "s");
    std::vector<std::uint32_t> told;
    for (const std::size_t contour : applied.contours) {
      const std::uint32_t plan = recipes.by_contour[contour];
      if (std::ranges::find(told, plan) != told.end()) continue;
      told.push_back(plan);
      line += "; " + how(recipes.plans[plan]);
    }
    lines.push_back(std::move(line));
  }
  return lines;
}

}  // namespace sim::cut
