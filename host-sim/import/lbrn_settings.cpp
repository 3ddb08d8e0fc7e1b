#include "host-sim/import/lbrn_settings.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "host-sim/import/scanner.hpp"

namespace sim::drawing {
namespace {

// Colours of the layers, by their index. The last two colours belong to the tool layers.
constexpr std::array<std::string_view, 32> kLbrnPalette{
    "#000000", "#0000ff", "#ff0000", "#00e000", "#d0d000", "#ff8000", "#00e0e0", "#ff00ff",
    "#b4b4b4", "#0000a0", "#a00000", "#00a000", "#a0a000", "#c08000", "#00a0ff", "#a000a0",
    "#808080", "#7d87b9", "#bb7784", "#4a6fe3", "#d33f6a", "#8cd78c", "#f0b98d", "#f6c4e1",
    "#fa9ed4", "#500a78", "#b45a00", "#004754", "#86fa88", "#ffdb66", "#f36926", "#0c96d9"};
constexpr int kFirstToolLayer = 30;

/// Returns the number of the element `<name Value="…"/>` within a setting. If there is none,
/// returns the number of the attribute `name` of the setting.
std::optional<double> value_of(const pugi::xml_node& setting, const char* name) {
  const pugi::xml_node child = setting.child(name);
  const char* const text = child ? child.attribute("Value").value() : "";
  Scanner scanner{text};
  const auto number = scanner.number();
  if (!number || !scanner.at_end()) return {};
  return number;
}

std::optional<double> share_of_percent(const std::optional<double>& percent) {
  if (!percent || !(*percent >= 0.0) || !(*percent <= 100.0)) return {};
  return 0.01 * *percent;
}

}  // namespace

OfferedSettings offered_by(const pugi::xml_node& setting) {
  constexpr double kMaxPasses = 1000.0;
  constexpr double kFastestMmS = 1.0e5;
  constexpr double kWidestInterval = 100.0;
  constexpr double kGreatestAngle = 360.0;
  constexpr double kGreatestKerfOffset = 10.0;
  OfferedSettings offered{.kind = setting.attribute("type").value(),
                          .power_share = share_of_percent(value_of(setting, "maxPower")),
                          .min_power_share = share_of_percent(value_of(setting, "minPower"))};
  const auto speed = value_of(setting, "speed");
  if (speed && *speed > 0.0 && *speed <= kFastestMmS) offered.speed_mm_s = speed;
  const auto passes = value_of(setting, "numPasses");
  if (passes && *passes >= 1.0 && *passes <= kMaxPasses) {
    offered.passes = static_cast<std::size_t>(*passes);
  }
  const auto priority = value_of(setting, "priority");
  if (priority && std::abs(*priority) <= 1.0e6) offered.priority = static_cast<int>(*priority);
  const auto interval = value_of(setting, "interval");
  if (interval && *interval > 0.0 && *interval <= kWidestInterval) offered.interval_mm = interval;
  const auto angle = value_of(setting, "angle");
  if (angle && std::abs(*angle) <= kGreatestAngle) offered.angle_deg = angle;
  const auto kerf = value_of(setting, "kerf");
  if (kerf && *kerf != 0.0 && std::abs(*kerf) <= kGreatestKerfOffset) offered.kerf_offset_mm = kerf;
  offered.shading = setting.child("ditherMode").attribute("Value").value();
  return offered;
}

std::string note_of_kerf_offset(double offset_mm) {
  return fmt::format(
      "the kerf offset of {0:g} mm is not used: set --kerf {1:g}, the full width of the kerf, "
      "instead",
      offset_mm,
      2.0 * std::abs(offset_mm));
}

LbrnLayer lbrn_layer_without_settings(int index) {
  const bool is_known = index >= 0 && index < static_cast<int>(kLbrnPalette.size());
  const bool is_tool = is_known && index >= kFirstToolLayer;
  LbrnLayer found{.layer = {.name = is_tool ? fmt::format("T{}", index - kFirstToolLayer + 1)
                                            : fmt::format("C{:02}", index),
                            .colour = {}},
                  .is_output = !is_tool};
  if (is_known) found.layer.colour = kLbrnPalette.at(static_cast<std::size_t>(index));
  return found;
}

std::map<int, LbrnLayer> lbrn_layers(const pugi::xml_node& project, LbrnUse use) {
  std::map<int, LbrnLayer> layers;
  for (const pugi::xml_node& setting : project.children()) {
    const std::string_view tag = setting.name();
    if (tag != "CutSetting" && tag != "CutSetting_Img") continue;
    const auto index = value_of(setting, "index");
    if (!index || std::abs(*index) > 1.0e6) continue;
    const int number = static_cast<int>(*index);
    LbrnLayer layer = lbrn_layer_without_settings(number);
    const std::string_view name = setting.child("name").attribute("Value").value();
    if (!name.empty()) layer.layer.name = name;
    layer.layer.offered = offered_by(setting);
    if (value_of(setting, "doOutput") == 0.0) layer.is_output = false;
    layer.has_sub_layers = !setting.child("SubLayer").empty();
    // If an index has two settings, the file contains the setting for lines first, and the setting
    // for pictures second.
    if (use == LbrnUse::kPictures && tag == "CutSetting_Img") {
      layers.insert_or_assign(number, std::move(layer));
    } else {
      layers.emplace(number, std::move(layer));
    }
  }
  return layers;
}

}  // namespace sim::drawing
