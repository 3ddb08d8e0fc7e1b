#include "host-sim/cli/cut_layers.hpp"

#include <fmt/format.h>

#include <optional>
#include <stdexcept>

#include "host-sim/report/nearest_name.hpp"

namespace sim {
namespace {

using cut::LayerSettings;
using drawing::Drawing;

std::vector<cut::LayerRule> rules_of(const CutCommandOptions& options,
                                     const Drawing& drawn,
                                     InputFiles& inputs) {
  std::vector<cut::LayerRule> rules;
  if (!options.layers_file.empty()) {
    rules =
        cut::read_rules(inputs.read_and_add("layers", options.layers_file), options.layers_file);
  }
  for (const std::string& text : options.layers) rules.push_back(cut::parse_rule(text, "--layer"));
  for (const cut::LayerRule& rule : rules) {
    std::string known;
    std::vector<std::string> names;
    bool found = false;
    for (const drawing::Layer& layer : drawn.layers) {
      found = found || rule.name == layer.name || rule.name == layer.colour;
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

cut::Condition condition_of(const CutCommandOptions& options,
                            const MaterialRecord& record,
                            const LayerSettings& settings) {
  const std::uint32_t most = options.full_power_w > 0.0
                                 ? thousandths_of("--full-power", options.full_power_w, 4.0e6, "W")
                                 : cnc::kerf::kMostPowerMw;
  std::optional<std::uint32_t> power;
  std::optional<std::uint32_t> speed;
  if (settings.power_w) power = power_option(*settings.power_w);
  if (settings.feed_mm_min) speed = speed_option(*settings.feed_mm_min);
  return cut::choose(record, thickness_option(options.thickness_mm), power, speed, most);
}

/// Returns power and feed of a layer that is engraved. Those of a cut are chosen only where the
/// layer does not give both.
cut::Condition engraving_of(const CutCommandOptions& options,
                            const MaterialRecord& record,
                            const LayerSettings& settings,
                            const LayerSettings& common) {
  std::optional<std::uint32_t> power;
  std::optional<std::uint32_t> speed;
  if (settings.power_w) power = power_option(*settings.power_w);
  if (settings.feed_mm_min) speed = speed_option(*settings.feed_mm_min);
  cut::Condition cut{{thickness_option(options.thickness_mm), 0, 0}};
  if (!power || !speed) cut = condition_of(options, record, common);
  return cut::engraving(cut, 0.01 * options.shop.mark_percent, power, speed);
}

/// Names the layer of what is not permissible.
cut::Condition condition_for(const drawing::Layer& layer,
                             const CutCommandOptions& options,
                             const MaterialRecord& record,
                             const LayerSettings& settings,
                             const LayerSettings& common) {
  try {
    if (settings.side == cut::Side::kMark) return engraving_of(options, record, settings, common);
    return condition_of(options, record, settings);
  } catch (const std::invalid_argument& error) {
    throw std::invalid_argument(
        fmt::format("layer \"{}\" {}: {}", layer.name, layer.colour, error.what()));
  }
}

}  // namespace

std::vector<cut::LayerPlan> layers_of(const CutCommandOptions& options,
                                      const Drawing& drawn,
                                      const MaterialRecord& record,
                                      InputFiles& inputs) {
  LayerSettings common;
  for (const auto& [key, value] : options.common) {
    try {
      set(common, key, value);
    } catch (const std::invalid_argument& error) {
      throw std::invalid_argument(fmt::format("--{}", error.what()));
    }
  }
  const std::vector<cut::LayerRule> rules = rules_of(options, drawn, inputs);
  std::vector<cut::LayerPlan> layers;
  for (const drawing::Layer& layer : drawn.layers) {
    cut::LayerPlan plan{settings_for(layer, common, rules), {}};
    if (cut::is_driven(plan.settings.side)) {
      plan.condition = condition_for(layer, options, record, plan.settings, common);
    }
    layers.push_back(plan);
  }
  return layers;
}

cut::Recipes recipes_of(const CutCommandOptions& options,
                        const Drawing& drawn,
                        const std::vector<cut::LayerPlan>& layers,
                        const MaterialRecord& record,
                        InputFiles& inputs) {
  return apply_rules(
      shop_rules(options.shop, inputs),
      drawn,
      layers,
      options.thickness_mm,
      0.01 * options.shop.mark_percent,
      [&](const LayerSettings& settings) { return condition_of(options, record, settings); });
}

}  // namespace sim
