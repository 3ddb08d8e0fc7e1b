#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "host-sim/cut/condition.hpp"
#include "host-sim/cut/layer_settings.hpp"
#include "host-sim/cut/shop_rule.hpp"
#include "host-sim/import/drawing.hpp"

namespace sim::cut {

/// Settings for cutting the contours of one layer, with the chosen power and speed.
struct LayerPlan {
  LayerSettings settings;
  Condition condition;
};

/// Returns `kerf 0.1234 mm`. For a layer without a kerf, returns `engraved`, `scored`, `filled` or
/// `burnt as a picture`.
[[nodiscard]] std::string width_text(const LayerPlan& plan);

/// A rule of the shop, with the numbers of the contours to which it applies.
struct AppliedRule {
  ShopRule rule;
  std::vector<std::size_t> contours{};
};

/// Plans of the contours that rules treat differently from their layers.
struct Recipes {
  static constexpr std::uint32_t kOfLayer = UINT32_MAX;

  std::vector<LayerPlan> plans{};
  /// Index into `plans` for each contour; kOfLayer if no rule applies to the contour. Empty if
  /// there are no rules.
  std::vector<std::uint32_t> by_contour{};
  /// The rules, each with its contours, in the order of the rules.
  std::vector<AppliedRule> applied{};

  /// Returns the plan of a contour, or `layer` if the contour has none.
  [[nodiscard]] const LayerPlan& of(std::size_t contour, const LayerPlan& layer) const {
    if (contour >= by_contour.size() || by_contour[contour] == kOfLayer) return layer;
    return plans[by_contour[contour]];
  }
};

/// Function that chooses power and speed for settings, as choose() does for a layer. Throws
/// std::invalid_argument with the permissible conditions.
using ChooseCondition = std::function<Condition(const LayerSettings&)>;

/// Applies the rules, in their order, to all contours of layers that are not skipped. Later rules
/// change the settings that earlier rules made. The drawing and its layers determine, before any
/// rule applies, which contours are holes. A marked contour is engraved on its line with
/// `mark_share` of its layer's power. Throws std::invalid_argument with the place of the rule.
/// @param layers plan of each layer of the drawing
/// @param thickness_mm thickness of the sheet
[[nodiscard]] Recipes apply_rules(const std::vector<ShopRule>& rules,
                                  const drawing::Drawing& drawn,
                                  const std::vector<LayerPlan>& layers,
                                  double thickness_mm,
                                  double mark_share,
                                  const ChooseCondition& choose);

/// Returns a line for each rule: its text, the number of its contours, and the conditions with
/// which they are cut.
[[nodiscard]] std::vector<std::string> lines_of(const Recipes& recipes);

}  // namespace sim::cut
