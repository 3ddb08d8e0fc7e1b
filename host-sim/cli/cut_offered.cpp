#include "host-sim/cli/cut_offered.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>
#include <string_view>

#include "host-sim/cli/cut_layers.hpp"
#include "host-sim/cut/offered_settings.hpp"

namespace sim {
namespace {

using cut::LayerSettings;
using cut::OfferedValues;

/// Settings of a layer, and their sources.
struct LayerChoice {
  LayerSettings settings{};
  std::vector<std::string> taken{};  ///< Settings that were taken, as `key=value`.
  /// Reasons why offered settings were not taken, as clauses for one sentence.
  std::vector<std::string> not_taken{};
};

LayerSettings with_values(LayerSettings settings,
                          const std::vector<std::pair<std::string, std::string>>& values) {
  for (const auto& [key, value] : values) set(settings, key, value);
  return settings;
}

/// Returns the settings of a layer. Options for all cuts override the offered settings, and rules
/// override both.
LayerSettings applied(const CutCommandOptions& options,
                      const drawing::Layer& layer,
                      const std::vector<cut::LayerRule>& rules,
                      const OfferedValues& offered) {
  const LayerSettings base = with_values({}, offered.values);
  return settings_for(layer, common_settings(options, base), rules, base);
}

/// Returns whether the command line sets `key` for a layer: by a rule of the layer, or by an option
/// for all cuts. Options for all cuts do not apply to an engraved layer.
/// @param own rules that apply to the layer
bool is_said(const CutCommandOptions& options,
             const std::vector<const cut::LayerRule*>& own,
             bool engraved,
             std::string_view key) {
  const auto gives = [key](const auto& values) {
    return std::ranges::any_of(values, [key](const auto& value) {
      return value.first == key || (key == "kind" && value.first == "side");
    });
  };
  if (!engraved && gives(options.common)) return true;
  return std::ranges::any_of(own, [&](const cut::LayerRule* rule) { return gives(rule->values); });
}

/// Returns `key=value`, suitable for the comment of a program, which cannot contain percent signs.
std::string text_of_value(const std::pair<std::string, std::string>& value) {
  const bool is_percent = value.second.ends_with('%');
  return fmt::format("{}={}{}",
                     value.first,
                     value.second.substr(0, value.second.size() - (is_percent ? 1 : 0)),
                     is_percent ? " percent" : "");
}

/// Drops all offered values except kind and rank.
void drop_operation(OfferedValues& offered, LayerChoice& choice, const std::string& reason) {
  std::string dropped;
  std::erase_if(offered.values, [&dropped](const auto& value) {
    if (value.first == "kind" || value.first == "rank") return false;
    dropped += (dropped.empty() ? "" : ", ") + text_of_value(value);
    return true;
  });
  if (!dropped.empty()) choice.not_taken.push_back(fmt::format("{} not used, {}", dropped, reason));
}

/// Returns the use of a layer's power and speed by the side on which the layer is driven: `lines`,
/// `filling` or `pictures`.
std::string_view use_of(cut::Side side) {
  if (side == cut::Side::kFill) return "filling";
  return side == cut::Side::kImage ? "pictures" : "lines";
}

LayerChoice choice_of(const CutCommandOptions& options,
                      const drawing::Layer& layer,
                      const std::vector<cut::LayerRule>& rules) {
  OfferedValues offered;
  if (layer.offered) offered = cut::values_of(*layer.offered);
  LayerChoice choice{.not_taken = offered.unusable};
  const LayerSettings as_offered = with_values({}, offered.values);
  choice.settings = applied(options, layer, rules, offered);
  const cut::Side side = choice.settings.side;
  std::string reason;
  if (use_of(side) != use_of(as_offered.side)) {
    reason = fmt::format("because they are for {}", use_of(as_offered.side));
  } else if (!is_engraved(side) && !options.record.material.empty()) {
    reason = "because the material gives them";
  }
  if (!reason.empty()) {
    drop_operation(offered, choice, reason);
    choice.settings = applied(options, layer, rules, offered);
  }
  const auto own = rules_for(layer, rules);
  for (const auto& value : offered.values) {
    if (is_said(options, own, is_engraved(side), value.first)) continue;
    choice.taken.push_back(text_of_value(value));
  }
  return choice;
}

}  // namespace

LayerSettings settings_of_layer(const CutCommandOptions& options,
                                const drawing::Layer& layer,
                                const std::vector<cut::LayerRule>& rules) {
  return choice_of(options, layer, rules).settings;
}

std::vector<std::string> offered_lines(const CutCommandOptions& options,
                                       const drawing::Drawing& drawn,
                                       const std::vector<cut::LayerRule>& rules) {
  std::vector<std::string> lines;
  for (const drawing::Layer& layer : drawn.layers) {
    if (!layer.offered) continue;
    const LayerChoice choice = choice_of(options, layer, rules);
    if (choice.taken.empty() && choice.not_taken.empty()) continue;
    const std::string taken =
        choice.taken.empty() ? "nothing" : fmt::format("{}", fmt::join(choice.taken, ", "));
    lines.push_back(fmt::format("taken from the project for layer \"{}\" {}: {}{}{}",
                                layer.name,
                                layer.colour,
                                taken,
                                choice.not_taken.empty() ? "" : "; ",
                                fmt::join(choice.not_taken, "; ")));
  }
  return lines;
}

}  // namespace sim
