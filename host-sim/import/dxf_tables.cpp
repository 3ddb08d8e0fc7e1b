#include "host-sim/import/dxf_tables.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdlib>
#include <utility>

namespace sim::drawing {
namespace {

/// Returns the family of a font by the name of its file; empty for a stroke font, which only the
/// drawing program has.
std::string family_of(std::string_view file) {
  file.remove_prefix(file.find_last_of("/\\") + 1);
  const std::size_t dot = file.rfind('.');
  const std::string ending = dot == std::string_view::npos ? "" : dxf_key(file.substr(dot));
  if (ending != ".TTF" && ending != ".TTC" && ending != ".OTF") return {};
  const std::string stem = dxf_key(file.substr(0, dot));
  if (stem.starts_with("ARIAL")) return "Arial";
  if (stem.starts_with("TIMES")) return "Times New Roman";
  if (stem.starts_with("COUR")) return "Courier New";
  return std::string{file.substr(0, dot)};
}

}  // namespace

std::optional<double> millimetres_per_dxf_unit(int unit) {
  constexpr double kSurveyFoot = 1200.0e3 / 3937.0;
  static constexpr std::array<double, 25> kUnits{0.0,
                                                 25.4,
                                                 304.8,
                                                 1609344.0,
                                                 1.0,
                                                 10.0,
                                                 1000.0,
                                                 1.0e6,
                                                 2.54e-5,
                                                 0.0254,
                                                 914.4,
                                                 1.0e-7,
                                                 1.0e-6,
                                                 1.0e-3,
                                                 100.0,
                                                 1.0e4,
                                                 1.0e5,
                                                 1.0e12,
                                                 1.495978707e14,
                                                 9.4607304725808e18,
                                                 3.0856775814913673e19,
                                                 kSurveyFoot,
                                                 kSurveyFoot / 12.0,
                                                 3.0 * kSurveyFoot,
                                                 5280.0 * kSurveyFoot};
  if (unit <= 0 || unit >= static_cast<int>(kUnits.size())) return {};
  return kUnits.at(static_cast<std::size_t>(unit));
}

std::string dxf_key(std::string_view name) {
  std::string key{name};
  std::ranges::transform(key, key.begin(), [](char c) {
    return c >= 'a' && c <= 'z' ? static_cast<char>(c - 32) : c;
  });
  return key;
}

std::string dxf_colour(double rgb) {
  return fmt::format("#{:06x}", static_cast<unsigned>(std::clamp(rgb, 0.0, 16777215.0)));
}

void DxfHeader::take(std::string_view variable, const DxfGroup& group) {
  if (group.code != 70) return;
  const double number = dxf_number(group.value).value_or(-1.0);
  if (variable == "$MEASUREMENT") is_english = number == 0.0;
  if (variable != "$INSUNITS") return;
  mm_per_unit = millimetres_per_dxf_unit(static_cast<int>(std::clamp(number, -1.0, 1.0e3)));
}

void DxfTables::add_layer(const DxfEntity& record) {
  constexpr int kFrozen = 1;
  const int colour = record.whole(62, 7);
  DxfLayer layer{.name = std::string{record.text(2)},
                 .colour = fmt::format("ACI {}", std::abs(colour)),
                 .line_type = dxf_key(record.text(6))};
  if (record.whole(290, 1) == 0) layer.hidden = "not plotted";
  if (colour < 0) layer.hidden = "off";
  if ((record.whole(70, 0) & kFrozen) != 0) layer.hidden = "frozen";
  if (const auto rgb = record.number(420)) layer.colour = dxf_colour(*rgb);
  layers_.insert_or_assign(dxf_key(layer.name), std::move(layer));
}

void DxfTables::add_line_type(const DxfEntity& record) {
  if (record.whole(73, 0) == 0) without_gaps_.insert(dxf_key(record.text(2)));
}

/// Adds a style. The family of its font comes from the extended data of the record or, without
/// them, from the name of the font file.
void DxfTables::add_style(const DxfEntity& record) {
  DxfStyle style{.file = std::string{record.text(3)},
                 .height = record.number(40, 0.0),
                 .width = record.number(41, 1.0),
                 .oblique_deg = record.number(50, 0.0),
                 .flags = record.whole(71, 0)};
  constexpr std::uint32_t kBold = 0x2000000U;
  constexpr std::uint32_t kItalic = 0x1000000U;
  const auto bits = static_cast<std::uint32_t>(record.whole(1071, 0));
  style.font.family = std::string{record.text(1000)};
  if (style.font.family.empty()) style.font.family = family_of(style.file);
  if ((bits & kBold) != 0) style.font.weight = 700;
  style.font.is_slanted = (bits & kItalic) != 0;
  if (!(style.width > 0.0)) style.width = 1.0;
  styles_.insert_or_assign(dxf_key(record.text(2)), std::move(style));
}

DxfStyle DxfTables::style(std::string_view name) const {
  const auto found = styles_.find(dxf_key(name.empty() ? "STANDARD" : name));
  return found != styles_.end() ? found->second : DxfStyle{};
}

DxfLayer DxfTables::layer(std::string_view name) const {
  const auto found = layers_.find(dxf_key(name));
  return found != layers_.end() ? found->second : DxfLayer{.name = std::string{name}};
}

bool DxfTables::is_dashed(std::string_view line_type) const {
  return !without_gaps_.contains(dxf_key(line_type));
}

}  // namespace sim::drawing
