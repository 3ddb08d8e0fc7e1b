#include "host-sim/cut/layer_settings.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <stdexcept>
#include <utility>

#include "host-sim/cut/layer_colour.hpp"
#include "host-sim/import/stroke_colour.hpp"
#include "host-sim/report/nearest_name.hpp"

namespace sim::cut {
namespace {

constexpr double kLongestWay = 1000.0;     ///< Greatest length of leads, tabs and overcuts, mm.
constexpr double kLongestPierce = 60.0;    ///< Greatest time of pierces and dwells, s.
constexpr double kGreatestNumber = 1.0e6;  ///< Greatest power in W and feed in mm/min.
constexpr unsigned kMaxTabs = 1000;
constexpr double kMaxCommonLine = 1.0;  ///< Greatest gap between two cuts that become one, mm.
/// Greatest width that a cut in narrow waste may take off an edge, mm.
constexpr double kMaxNarrow = 1.0;
/// Greatest distance by which Z moves down with each pass, mm.
constexpr double kDeepestStep = 100.0;
constexpr std::string_view kAnyLayer = "*";
constexpr std::string_view kRuleForm = "rule `LAYER: key=value, key=value`";

/// Keys that are valid only for a filled layer. Two of them are also valid for a layer of pictures.
constexpr std::array<std::string_view, 4> kFillKeys{"interval", "angle", "overscan", "pattern"};
/// Keys that are valid for an engraved line.
constexpr std::array<std::string_view, 10> kMarkKeys{
    "power", "feed", "side", "kind", "start", "rank", "passes", "passes-by", "z-step", "air"};

Lead lead_from(std::string_view key, std::string_view text) {
  if (text == "none") return {};
  const std::size_t colon = text.find(':');
  const std::string_view kind = text.substr(0, colon);
  if (colon == std::string_view::npos || (kind != "line" && kind != "arc")) {
    throw std::invalid_argument(
        fmt::format("{}={}: must be `none`, `line:MM` or `arc:MM`, such as arc:2", key, text));
  }
  return {kind == "line" ? LeadKind::kLine : LeadKind::kArc,
          number_from(key, text.substr(colon + 1), 0.01, kLongestWay, "mm"),
          true};
}

Side side_from(std::string_view text) {
  if (text == "waste") return Side::kWaste;
  if (text == "on") return Side::kOn;
  if (text == "mark") return Side::kMark;
  if (text == "image") return Side::kImage;
  if (text == "skip") return Side::kSkip;
  if (text == "start") return Side::kStart;
  throw std::invalid_argument(
      fmt::format("side={}: must be `waste`, `on`, `mark`, `image`, `skip` or `start`", text));
}

template <std::size_t kCount>
bool holds(const std::array<std::string_view, kCount>& keys, std::string_view key) {
  return std::ranges::find(keys, key) != keys.end();
}

/// Returns whether a layer of pictures may have the setting `key`.
bool is_for_image(std::string_view key) {
  if (key == "start" || key == "z-step") return false;
  if (key == "angle" || key == "pattern") return false;
  return holds(kImageKeys, key) || holds(kFillKeys, key) || holds(kMarkKeys, key);
}

/// Throws std::invalid_argument if a rule has keys that are not valid for the side of its layer.
void expect_of_side(const LayerRule& rule, const LayerSettings& settings) {
  const Side side = settings.side;
  const bool has_lines = settings.fill.pattern == FillPattern::kLines;
  const auto refuse =
      [&rule](std::string_view key, const std::string& value, const std::string& reason) {
        throw std::invalid_argument(fmt::format("{}: {}={}: {}", rule.place, key, value, reason));
      };
  for (const auto& [key, value] : rule.values) {
    if (side == Side::kImage) {
      if (!is_for_image(key)) refuse(key, value, "is not for pictures; leave it out");
      continue;
    }
    if (holds(kImageKeys, key)) refuse(key, value, "is for a layer with kind=image; leave it out");
    if (holds(kFillKeys, key)) {
      if (side != Side::kFill) refuse(key, value, "is for a layer with kind=fill; leave it out");
      const bool is_of_lines = key == "angle" || key == "overscan";
      if (is_of_lines && !has_lines) refuse(key, value, "is for pattern=lines; leave it out");
      continue;
    }
    if (!is_engraved(side) || holds(kMarkKeys, key)) continue;
    refuse(key,
           value,
           fmt::format("an engraved layer takes {}; a filled one also takes {}",
                       fmt::join(kMarkKeys, ", "),
                       fmt::join(kFillKeys, ", ")));
  }
}

void set_kind(LayerSettings& settings, std::string_view text) {
  constexpr std::array<std::pair<std::string_view, Side>, 6> kKinds{{{"cut", Side::kWaste},
                                                                     {"score", Side::kMark},
                                                                     {"engrave", Side::kMark},
                                                                     {"fill", Side::kFill},
                                                                     {"image", Side::kImage},
                                                                     {"skip", Side::kSkip}}};
  for (const auto& [name, side] : kKinds) {
    if (name != text) continue;
    settings.side = side;
    settings.is_scored = name == "score";
    return;
  }
  throw std::invalid_argument(
      fmt::format("kind={}: must be `cut`, `score`, `engrave`, `fill`, `image` or `skip`", text));
}

void set_power(LayerSettings& settings, std::string_view text) {
  const PowerWish wish = power_from("power", text);
  settings.power_w = wish.watts;
  settings.power_share = wish.share;
}

FillPattern pattern_from(std::string_view text) {
  if (text == "lines") return FillPattern::kLines;
  if (text == "contour") return FillPattern::kContour;
  throw std::invalid_argument(fmt::format("pattern={}: must be `lines` or `contour`", text));
}

Air air_from(std::string_view text) {
  if (text == "on" || text == "M8") return Air::kFlood;
  if (text == "M7") return Air::kMist;
  if (text == "off") return Air::kOff;
  throw std::invalid_argument(fmt::format("air={}: must be `on`, `M7`, `M8` or `off`", text));
}

bool passes_by_layer_from(std::string_view text) {
  if (text == "contour" || text == "layer") return text == "layer";
  throw std::invalid_argument(fmt::format("passes-by={}: must be `contour` or `layer`", text));
}

StartAt start_from(std::string_view text) {
  if (text == "any") return StartAt::kAny;
  if (text == "straight") return StartAt::kStraight;
  if (text == "corner") return StartAt::kCorner;
  if (text == "usual") return StartAt::kUsual;
  if (text == "tab") return StartAt::kTab;
  throw std::invalid_argument(
      fmt::format("start={}: must be `any`, `straight`, `corner`, `usual` or `tab`", text));
}

struct KeySetter {
  std::string_view key;
  void (*set)(LayerSettings& settings, std::string_view value);
};

unsigned count_from(std::string_view key, std::string_view text, double least, const char* unit) {
  return static_cast<unsigned>(number_from(key, text, least, kMaxTabs, unit));
}

/// All keys except kImageKeys, with the functions that set their values.
constexpr std::array<KeySetter, 25> kSetters{{
    {"power", set_power},
    {"feed",
     [](LayerSettings& settings, std::string_view value) {
       settings.feed_mm_min = number_from("feed", value, 0.001, kGreatestNumber, "mm/min");
     }},
    {"side",
     [](LayerSettings& settings, std::string_view value) {
       settings.side = side_from(value);
       settings.is_scored = false;
     }},
    {"lead-in",
     [](LayerSettings& settings, std::string_view value) {
       settings.lead_in = lead_from("lead-in", value);
     }},
    {"lead-out",
     [](LayerSettings& settings, std::string_view value) {
       settings.lead_out = lead_from("lead-out", value);
     }},
    {"overcut",
     [](LayerSettings& settings, std::string_view value) {
       settings.overcut_mm = number_from("overcut", value, 0.0, kLongestWay, "mm");
     }},
    {"tabs",
     [](LayerSettings& settings, std::string_view value) {
       settings.tabs = count_from("tabs", value, 0.0, "tabs");
     }},
    {"tab-width",
     [](LayerSettings& settings, std::string_view value) {
       settings.tab_mm = number_from("tab-width", value, 0.01, kLongestWay, "mm");
     }},
    {"pierce",
     [](LayerSettings& settings, std::string_view value) {
       settings.pierce_s = number_from("pierce", value, 0.0, kLongestPierce, "s");
     }},
    {"corner-loop",
     [](LayerSettings& settings, std::string_view value) {
       settings.corner_loop_mm = number_from("corner-loop", value, 0.0, kLongestWay, "mm");
     }},
    {"corner-dwell",
     [](LayerSettings& settings, std::string_view value) {
       settings.corner_dwell_s = number_from("corner-dwell", value, 0.0, kLongestPierce, "s");
     }},
    {"corner-angle",
     [](LayerSettings& settings, std::string_view value) {
       settings.corner_angle_deg = number_from("corner-angle", value, 1.0, 180.0, "degrees");
     }},
    {"common-line",
     [](LayerSettings& settings, std::string_view value) {
       settings.common_line_mm = number_from("common-line", value, 0.0, kMaxCommonLine, "mm");
     }},
    {"narrow",
     [](LayerSettings& settings, std::string_view value) {
       settings.narrow_mm = number_from("narrow", value, 0.0, kMaxNarrow, "mm");
     }},
    {"start",
     [](LayerSettings& settings, std::string_view value) { settings.start = start_from(value); }},
    {"rank",
     [](LayerSettings& settings, std::string_view value) {
       settings.rank = count_from("rank", value, 0.0, "as a rank");
     }},
    {"kind", set_kind},
    {"passes",
     [](LayerSettings& settings, std::string_view value) {
       settings.passes = count_from("passes", value, 1.0, "passes");
     }},
    {"passes-by",
     [](LayerSettings& settings, std::string_view value) {
       settings.passes_by_layer = passes_by_layer_from(value);
     }},
    {"z-step",
     [](LayerSettings& settings, std::string_view value) {
       settings.z_step_mm = number_from("z-step", value, 0.0, kDeepestStep, "mm");
     }},
    {"air",
     [](LayerSettings& settings, std::string_view value) { settings.air = air_from(value); }},
    {"interval",
     [](LayerSettings& settings, std::string_view value) {
       settings.fill.interval_mm = number_from("interval", value, 0.005, 100.0, "mm");
     }},
    {"angle",
     [](LayerSettings& settings, std::string_view value) {
       settings.fill.angle_deg = number_from("angle", value, -360.0, 360.0, "degrees");
     }},
    {"overscan",
     [](LayerSettings& settings, std::string_view value) {
       settings.fill.overscan_mm = number_from("overscan", value, 0.0, kLongestWay, "mm");
     }},
    {"pattern",
     [](LayerSettings& settings, std::string_view value) {
       settings.fill.pattern = pattern_from(value);
     }},
}};

/// Throws std::invalid_argument with the place of the rule for unknown keys and invalid values.
void expect_settings(const LayerRule& rule) {
  LayerSettings tried;
  try {
    for (const auto& [key, value] : rule.values) set(tried, key, value);
  } catch (const std::invalid_argument& error) {
    throw std::invalid_argument(fmt::format("{}: {}", rule.place, error.what()));
  }
}

}  // namespace

void power_in_watts(LayerSettings& settings, double full_power_w, double full_power_s) {
  const auto turn =
      [&](const char* key, std::optional<double>& watts, std::optional<PowerShare>& share) {
        if (!share) return;
        if (share->is_s && share->value > full_power_s) {
          throw std::invalid_argument(
              fmt::format("{}=S{:g}: is more than S{:g} ($30), the machine's greatest S",
                          key,
                          share->value,
                          full_power_s));
        }
        watts = share->value / (share->is_s ? full_power_s : 100.0) * full_power_w;
        share.reset();
      };
  turn("power", settings.power_w, settings.power_share);
  turn("min-power", settings.image.min_power.watts, settings.image.min_power.share);
}

void set(LayerSettings& settings, std::string_view key, std::string_view value) {
  for (const KeySetter& setter : kSetters) {
    if (setter.key == key) return setter.set(settings, value);
  }
  if (holds(kImageKeys, key)) return set_image(settings.image, key, value);
  std::vector<std::string> keys;
  keys.reserve(kSetters.size() + kImageKeys.size());
  for (const KeySetter& setter : kSetters) keys.emplace_back(setter.key);
  for (const std::string_view image_key : kImageKeys) keys.emplace_back(image_key);
  throw std::invalid_argument(fmt::format("{}: there is no such setting; settings are {}{}",
                                          key,
                                          fmt::join(keys, ", "),
                                          did_you_mean(std::string{key}, keys)));
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

bool names(const LayerRule& rule, const drawing::Layer& layer) {
  return rule.name == layer.name || rule.name == layer.colour ||
         is_colour_named(layer.colour, rule.name);
}

std::vector<const LayerRule*> rules_for(const drawing::Layer& layer,
                                        const std::vector<LayerRule>& rules) {
  std::vector<const LayerRule*> own;
  for (const LayerRule& rule : rules) {
    if (names(rule, layer)) own.push_back(&rule);
  }
  if (!own.empty()) return own;
  for (const LayerRule& rule : rules) {
    if (rule.name == kAnyLayer) own.push_back(&rule);
  }
  return own;
}

LayerSettings settings_for(const drawing::Layer& layer,
                           const LayerSettings& common,
                           const std::vector<LayerRule>& rules,
                           const LayerSettings& engraved) {
  const std::vector<const LayerRule*> own = rules_for(layer, rules);
  const auto with_own = [&own](LayerSettings settings) {
    for (const LayerRule* rule : own) {
      for (const auto& [key, value] : rule->values) set(settings, key, value);
    }
    return settings;
  };
  // Text that consists of single strokes has no inside, so it cannot be cut at an offset.
  const bool is_stroke_text = layer.colour == drawing::kStrokeTextColour;
  LayerSettings base = common;
  if (is_stroke_text) base.side = Side::kMark;
  LayerSettings settings = with_own(base);
  const bool is_picture = layer.colour == drawing::kPictureColour;
  if (is_picture && settings.side != Side::kImage) {
    settings.side = Side::kSkip;
    return settings;
  }
  for (const LayerRule* rule : own) expect_of_side(*rule, settings);
  if (!is_engraved(settings.side)) return settings;
  base = engraved;
  base.side = settings.side;
  return with_own(base);
}

}  // namespace sim::cut
