#include "host-sim/cli/cut_layers.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <stdexcept>

#include "host-sim/cli/cut_offered.hpp"
#include "host-sim/cli/cut_pictures.hpp"
#include "host-sim/report/nearest_name.hpp"

namespace sim {
namespace {

using cut::LayerSettings;
using drawing::Drawing;

bool asks_for_thickness(const cut::ShopRule& rule) {
  return std::ranges::any_of(rule.comparisons, [](const cut::Comparison& comparison) {
    return comparison.of_thickness || comparison.quantity == cut::Quantity::kThickness;
  });
}

}  // namespace

std::vector<cut::LayerRule> layer_rules_of(const CutCommandOptions& options,
                                           const Drawing& drawn,
                                           InputFiles& inputs) {
  std::vector<cut::LayerRule> rules;
  if (!options.layers_file.empty()) {
    rules =
        cut::read_rules(inputs.read_and_add("layers", options.layers_file), options.layers_file);
  }
  rules.insert(rules.end(), options.recipe.layers.begin(), options.recipe.layers.end());
  for (const std::string& text : options.layers) rules.push_back(cut::parse_rule(text, "--layer"));
  for (const cut::LayerRule& rule : rules) {
    std::string known;
    std::vector<std::string> names;
    bool found = rule.name == "*";
    for (const drawing::Layer& layer : drawn.layers) {
      found = found || cut::names(rule, layer);
      names.insert(names.end(), {layer.name, layer.colour});
      known += fmt::format(" \"{}\" {};", layer.name, layer.colour);
    }
    if (found) continue;
    throw std::invalid_argument(
        fmt::format("{}: the drawing has no layer or colour \"{}\"; it has{}{}",
                    rule.place,
                    rule.name,
                    known,
                    did_you_mean(rule.name, names)));
  }
  return rules;
}

LayerSettings common_settings(const CutCommandOptions& options, LayerSettings base) {
  for (const auto& [key, value] : options.known) set(base, key, value);
  for (const auto& [key, value] : options.common) {
    try {
      set(base, key, value);
    } catch (const std::invalid_argument& error) {
      throw std::invalid_argument(fmt::format("--{}", error.what()));
    }
  }
  return base;
}

namespace {

/// Returns power and speed as the layer or the call gives them. Without a material, both must be
/// given.
cut::Condition given_condition(const LayerSettings& settings, std::uint32_t thickness_um) {
  const char* missing = nullptr;
  if (!settings.feed_mm_min)
    missing = "feed is not given; give --feed, or feed= for the layer, mm/min";
  if (!settings.power_w) {
    missing = "power is not given; give --power, or power= for the layer, as 40W, 60% or S600";
  }
  if (missing != nullptr) {
    throw std::invalid_argument(fmt::format("{}, or name a --material with known cuts", missing));
  }
  return {{thickness_um, power_option(*settings.power_w), speed_option(*settings.feed_mm_min)}};
}

cut::Condition chosen_condition(const CutSource& source, const LayerSettings& settings) {
  const CutCommandOptions& options = source.options;
  const std::uint32_t most = options.full_power_w > 0.0
                                 ? thousandths_of("--full-power", options.full_power_w, 4.0e6, "W")
                                 : cnc::kerf::kMaxPowerMw;
  std::optional<std::uint32_t> power;
  std::optional<std::uint32_t> speed;
  if (settings.power_w) power = power_option(*settings.power_w);
  if (settings.feed_mm_min) speed = speed_option(*settings.feed_mm_min);
  return cut::choose(
      *source.kerf.material, thickness_option(options.thickness_mm), power, speed, most);
}

cut::Condition condition_of(const CutSource& source, const LayerSettings& settings) {
  const CutKerf& kerf = source.kerf;
  if (!kerf.known_mm) {
    if (kerf.material) return chosen_condition(source, settings);
    if (!kerf.origin.empty()) {
      throw std::invalid_argument(
          fmt::format("the kerf of {} is not known ({}); give --kerf, such as 0.15, mm",
                      kerf.record.name,
                      kerf.origin));
    }
    throw std::invalid_argument(
        "the kerf is not known; give --kerf, such as 0.15, mm, or name a --material");
  }
  const std::uint32_t thickness_um = thickness_option(source.options.thickness_mm);
  const bool is_given = settings.power_w && settings.feed_mm_min;
  cut::Condition condition = kerf.material && !is_given ? chosen_condition(source, settings)
                                                        : given_condition(settings, thickness_um);
  condition.kerf_mm = *kerf.known_mm;
  condition.half_interval_mm = 0.0;
  return condition;
}

/// Returns power and feed of an engraved layer. If the layer does not give both, the missing ones
/// are chosen as for a cut.
cut::Condition engraving_of(const CutSource& source,
                            const LayerSettings& settings,
                            const LayerSettings& common) {
  std::optional<std::uint32_t> power;
  std::optional<std::uint32_t> speed;
  if (settings.power_w) power = power_option(*settings.power_w);
  if (settings.feed_mm_min) speed = speed_option(*settings.feed_mm_min);
  cut::Condition cut{{thickness_option(source.options.thickness_mm), 0, 0}};
  if (!power || !speed) {
    cut = source.kerf.material ? condition_of(source, common)
                               : given_condition(common, cut.cut.thickness_um);
  }
  return cut::engraving(cut, 0.01 * source.options.shop.mark_percent, power, speed);
}

/// Returns the condition of a layer. Errors that it throws name the layer.
cut::Condition condition_for(const drawing::Layer& layer,
                             const CutSource& source,
                             const LayerSettings& settings,
                             const LayerSettings& common) {
  try {
    if (settings.side == cut::Side::kImage) {
      return picture_condition(settings, thickness_option(source.options.thickness_mm));
    }
    if (is_engraved(settings.side)) return engraving_of(source, settings, common);
    return condition_of(source, settings);
  } catch (const std::invalid_argument& error) {
    throw std::invalid_argument(
        fmt::format("layer \"{}\" {}: {}", layer.name, layer.colour, error.what()));
  }
}

LayerSettings in_watts(LayerSettings settings, const cut::Beam& beam) {
  power_in_watts(settings, beam.full_power_w, beam.full_power_s);
  return settings;
}

}  // namespace

std::vector<cut::LayerSettings> power_wishes(const CutCommandOptions& options,
                                             const Drawing& drawn,
                                             const std::vector<cut::LayerRule>& rules) {
  std::vector<LayerSettings> wishes{common_settings(options)};
  for (const drawing::Layer& layer : drawn.layers) {
    const LayerSettings settings = settings_of_layer(options, layer, rules);
    if (cut::is_driven(settings.side)) wishes.push_back(settings);
  }
  return wishes;
}

std::vector<cut::LayerPlan> layers_of(const CutSource& source,
                                      const Drawing& drawn,
                                      const std::vector<cut::LayerRule>& rules) {
  const LayerSettings common = in_watts(common_settings(source.options), source.beam);
  std::vector<cut::LayerPlan> layers;
  for (const drawing::Layer& layer : drawn.layers) {
    cut::LayerPlan plan{in_watts(settings_of_layer(source.options, layer, rules), source.beam), {}};
    if (cut::is_driven(plan.settings.side)) {
      plan.condition = condition_for(layer, source, plan.settings, common);
    }
    layers.push_back(plan);
  }
  return layers;
}

cut::Recipes recipes_of(const CutSource& source,
                        const Drawing& drawn,
                        const std::vector<cut::LayerPlan>& layers,
                        InputFiles& inputs) {
  const std::vector<cut::ShopRule> rules = shop_rules(source.options.shop, inputs);
  for (const cut::ShopRule& rule : rules) {
    if (source.options.thickness_mm > 0.0 || !asks_for_thickness(rule)) continue;
    throw std::invalid_argument(
        fmt::format("{}: \"{}\": requires the thickness of the sheet; give --thickness, mm",
                    rule.place,
                    rule.text));
  }
  return apply_rules(rules,
                     drawn,
                     layers,
                     source.options.thickness_mm,
                     0.01 * source.options.shop.mark_percent,
                     [&](const LayerSettings& settings) { return condition_of(source, settings); });
}

}  // namespace sim
