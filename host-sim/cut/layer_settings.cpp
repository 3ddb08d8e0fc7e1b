#include "host-sim/cut/layer_settings.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "host-sim/import/stroke_colour.hpp"
#include "host-sim/report/nearest_name.hpp"

namespace sim::cut {
namespace {

constexpr double kLongestWay = 1000.0;     ///< mm, of leads, tabs and overcuts.
constexpr double kLongestPierce = 60.0;    ///< s, of pierces and dwells.
constexpr double kGreatestNumber = 1.0e6;  ///< W and mm/min.
constexpr unsigned kMostTabs = 1000;
constexpr double kMaxCommonLine = 1.0;  ///< mm.
constexpr std::string_view kRuleForm = "rule `LAYER: key=value, key=value`";

/// The keys, of which a message names the nearest.
const std::vector<std::string> kKeys{"power",
                                     "feed",
                                     "side",
                                     "lead-in",
                                     "lead-out",
                                     "overcut",
                                     "tabs",
                                     "tab-width",
                                     "pierce",
                                     "corner-loop",
                                     "corner-dwell",
                                     "corner-angle",
                                     "common-line",
                                     "start",
                                     "rank"};

Lead lead_from(std::string_view key, std::string_view text) {
  if (text == "none") return {};
  const std::size_t colon = text.find(':');
  const std::string_view kind = text.substr(0, colon);
  if (colon == std::string_view::npos || (kind != "line" && kind != "arc")) {
    throw std::invalid_argument(
        fmt::format("{}={}: wants `none`, `line:MM` or `arc:MM`, such as arc:2", key, text));
  }
  return {kind == "line" ? LeadKind::kLine : LeadKind::kArc,
          number_from(key, text.substr(colon + 1), 0.01, kLongestWay, "mm"),
          true};
}

Side side_from(std::string_view text) {
  if (text == "waste") return Side::kWaste;
  if (text == "on") return Side::kOn;
  if (text == "mark") return Side::kMark;
  if (text == "skip") return Side::kSkip;
  if (text == "start") return Side::kStart;
  throw std::invalid_argument(
      fmt::format("side={}: wants `waste`, `on`, `mark`, `skip` or `start`", text));
}

/// Throws std::invalid_argument for what a line that is engraved cannot have.
void expect_of_mark(const LayerRule& rule) {
  const std::vector<std::string_view> taken{"power", "feed", "side", "start", "rank"};
  for (const auto& [key, value] : rule.values) {
    if (std::ranges::find(taken, key) != taken.end()) continue;
    throw std::invalid_argument(fmt::format("{}: {}={}: with side=mark a layer has {} and no more",
                                            rule.place,
                                            key,
                                            value,
                                            fmt::join(taken, ", ")));
  }
}

StartAt start_from(std::string_view text) {
  if (text == "any") return StartAt::kAny;
  if (text == "straight") return StartAt::kStraight;
  if (text == "corner") return StartAt::kCorner;
  if (text == "usual") return StartAt::kUsual;
  if (text == "tab") return StartAt::kTab;
  throw std::invalid_argument(
      fmt::format("start={}: wants `any`, `straight`, `corner`, `usual` or `tab`", text));
}

/// Throws std::invalid_argument with the place for keys and values that mean nothing.
void expect_settings(const LayerRule& rule) {
  LayerSettings tried;
  try {
    for (const auto& [key, value] : rule.values) set(tried, key, value);
  } catch (const std::invalid_argument& error) {
    throw std::invalid_argument(fmt::format("{}: {}", rule.place, error.what()));
  }
}

}  // namespace

void set(LayerSettings& settings, std::string_view key, std::string_view value) {
  if (key == "power") {
    settings.power_w = number_from(key, value, 0.001, kGreatestNumber, "W");
  } else if (key == "feed") {
    settings.feed_mm_min = number_from(key, value, 0.001, kGreatestNumber, "mm/min");
  } else if (key == "side") {
    settings.side = side_from(value);
  } else if (key == "lead-in") {
    settings.lead_in = lead_from(key, value);
  } else if (key == "lead-out") {
    settings.lead_out = lead_from(key, value);
  } else if (key == "overcut") {
    settings.overcut_mm = number_from(key, value, 0.0, kLongestWay, "mm");
  } else if (key == "tabs") {
    settings.tabs = static_cast<unsigned>(number_from(key, value, 0.0, kMostTabs, "tabs"));
  } else if (key == "tab-width") {
    settings.tab_mm = number_from(key, value, 0.01, kLongestWay, "mm");
  } else if (key == "pierce") {
    settings.pierce_s = number_from(key, value, 0.0, kLongestPierce, "s");
  } else if (key == "corner-loop") {
    settings.corner_loop_mm = number_from(key, value, 0.0, kLongestWay, "mm");
  } else if (key == "corner-dwell") {
    settings.corner_dwell_s = number_from(key, value, 0.0, kLongestPierce, "s");
  } else if (key == "corner-angle") {
    settings.corner_angle_deg = number_from(key, value, 1.0, 180.0, "degrees");
  } else if (key == "common-line") {
    settings.common_line_mm = number_from(key, value, 0.0, kMaxCommonLine, "mm");
  } else if (key == "start") {
    settings.start = start_from(value);
  } else if (key == "rank") {
    settings.rank = static_cast<unsigned>(number_from(key, value, 0.0, kMostTabs, "as a rank"));
  } else {
    throw std::invalid_argument(fmt::format("{}: no such setting; there are {}{}",
                                            key,
                                            fmt::join(kKeys, ", "),
                                            did_you_mean(std::string{key}, kKeys)));
  }
}

LayerRule parse_rule(std::string_view text, std::string place) {
  LayerRule rule = parse_named_values(text, std::move(place), kRuleForm);
  expect_settings(rule);
  return rule;
}

std::vector<LayerRule> read_rules(const std::string& text, const std::string& file) {
  std::vector<LayerRule> rules = read_named_values(text, file, kRuleForm);
  for (const LayerRule& rule : rules) expect_settings(rule);
  return rules;
}

LayerSettings settings_for(const drawing::Layer& layer,
                           const LayerSettings& common,
                           const std::vector<LayerRule>& rules) {
  LayerSettings settings = common;
  // Single strokes have no side.
  if (layer.colour == drawing::kStrokeTextColour) settings.side = Side::kMark;
  std::vector<const LayerRule*> own;
  for (const LayerRule& rule : rules) {
    if (rule.name != layer.name && rule.name != layer.colour) continue;
    own.push_back(&rule);
    for (const auto& [key, value] : rule.values) set(settings, key, value);
  }
  if (settings.side != Side::kMark) return settings;
  LayerSettings engraved;
  engraved.side = Side::kMark;
  for (const LayerRule* rule : own) {
    expect_of_mark(*rule);
    for (const auto& [key, value] : rule->values) set(engraved, key, value);
  }
  return engraved;
}

}  // namespace sim::cut
