#include "host-sim/import/svg_attributes.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include "host-sim/import/scanner.hpp"

namespace sim::drawing {
namespace {

constexpr double kPxPerInch = 96.0;
constexpr double kRadiansPerDegree = kFullTurn / 360.0;

std::optional<double> px_per(std::string_view unit) {
  static constexpr std::array<std::pair<std::string_view, double>, 8> kUnits{
      {{"", 1.0},
       {"px", 1.0},
       {"mm", kPxPerInch / 25.4},
       {"cm", kPxPerInch / 2.54},
       {"in", kPxPerInch},
       {"pt", kPxPerInch / 72.0},
       {"pc", kPxPerInch / 6.0},
       {"Q", kPxPerInch / 101.6}}};
  const auto* const found = std::ranges::find(kUnits, unit, [](const auto& u) { return u.first; });
  if (found == kUnits.end()) return {};
  return found->second;
}

std::string_view trimmed(std::string_view text) {
  constexpr std::string_view kBlanks = " \t\r\n";
  const std::size_t from = text.find_first_not_of(kBlanks);
  if (from == std::string_view::npos) return {};
  return text.substr(from, text.find_last_not_of(kBlanks) - from + 1);
}

struct TransformCall {
  std::string_view name;
  std::array<double, 6> values{};
  std::size_t count = 0;
};

std::optional<Transform> rotation(const TransformCall& call) {
  const Transform turn = turned_by(call.values[0] * kRadiansPerDegree);
  if (call.count == 1) return turn;
  if (call.count != 3) return {};
  const Place about{call.values[1], call.values[2]};
  return moved_by(about) * turn * moved_by(-about);
}

std::optional<Transform> transform_of(const TransformCall& call) {
  const auto& v = call.values;
  const bool one_or_two = call.count == 1 || call.count == 2;
  if (call.name == "matrix" && call.count == 6) {
    return Transform{{v[0], v[1]}, {v[2], v[3]}, {v[4], v[5]}};
  }
  if (call.name == "translate" && one_or_two) return moved_by({v[0], v[1]});
  if (call.name == "scale" && one_or_two) return scaled_by(v[0], call.count == 2 ? v[1] : v[0]);
  if (call.name == "rotate") return rotation(call);
  if (call.name == "skewX" && call.count == 1) {
    return Transform{.y_axis{std::tan(v[0] * kRadiansPerDegree), 1.0}};
  }
  if (call.name == "skewY" && call.count == 1) {
    return Transform{.x_axis{1.0, std::tan(v[0] * kRadiansPerDegree)}};
  }
  return {};
}

std::optional<TransformCall> next_call(Scanner& scanner) {
  TransformCall call;
  call.name = scanner.word();
  if (!scanner.take('(')) return {};
  while (!scanner.take(')')) {
    const auto value = scanner.number();
    if (!value || call.count == call.values.size()) return {};
    call.values[call.count++] = *value;
    scanner.separate();
  }
  return call;
}

/// Where of the room left something lies: Min, Mid or Max.
double share_of(std::string_view align) {
  if (align.ends_with("Min")) return 0.0;
  return align.ends_with("Max") ? 1.0 : 0.5;
}

}  // namespace

std::optional<double> svg_length(std::string_view text,
                                 const SvgViewport& viewport,
                                 SvgDirection direction) {
  Scanner scanner{text};
  const auto value = scanner.number();
  if (!value) return {};
  const std::string_view unit = trimmed(scanner.rest());
  if (unit == "%") {
    const double diagonal = std::hypot(viewport.width, viewport.height) / std::sqrt(2.0);
    const double whole = direction == SvgDirection::kAcross    ? viewport.width
                         : direction == SvgDirection::kUpright ? viewport.height
                                                               : diagonal;
    return *value * whole / 100.0;
  }
  const auto px = px_per(unit);
  if (!px) return {};
  return *value * *px;
}

std::optional<Transform> svg_transform(std::string_view text) {
  Scanner scanner{text};
  Transform all;
  if (trimmed(text) == "none") return all;
  while (!scanner.at_end()) {
    const auto call = next_call(scanner);
    if (!call) return {};
    const auto transform = transform_of(*call);
    if (!transform || !transform->finite()) return {};
    all = all * *transform;
    scanner.separate();
  }
  return all;
}

std::optional<SvgViewBox> svg_view_box(std::string_view text) {
  Scanner scanner{text};
  std::array<double, 4> values{};
  for (double& value : values) {
    const auto number = scanner.number();
    if (!number) return {};
    value = *number;
    scanner.separate();
  }
  if (!scanner.at_end() || !(values[2] > 0.0) || !(values[3] > 0.0)) return {};
  return SvgViewBox{{values[0], values[1]}, {values[2], values[3]}};
}

Transform svg_fit(const SvgViewBox& box, const SvgViewport& viewport, std::string_view aspect) {
  double across = viewport.width / box.size.x();
  double upright = viewport.height / box.size.y();
  const std::string_view all = trimmed(aspect);
  const std::string_view align = all.empty() ? "xMidYMid" : all.substr(0, all.find(' '));
  if (align != "none") {
    across = upright =
        all.ends_with("slice") ? std::max(across, upright) : std::min(across, upright);
  }
  const Place room{viewport.width - across * box.size.x(),
                   viewport.height - upright * box.size.y()};
  const double x = align == "none" ? 0.0 : share_of(align.substr(0, 4)) * room.x();
  const double y = align == "none" ? 0.0 : share_of(align) * room.y();
  return moved_by({x, y}) * scaled_by(across, upright) * moved_by(-box.origin);
}

std::string svg_property(const pugi::xml_node& node, std::string_view name) {
  std::string_view style = node.attribute("style").value();
  while (!style.empty()) {
    const std::string_view rule = style.substr(0, style.find(';'));
    style.remove_prefix(std::min(style.size(), rule.size() + 1));
    const std::size_t colon = rule.find(':');
    if (colon == std::string_view::npos || trimmed(rule.substr(0, colon)) != name) continue;
    return std::string{trimmed(rule.substr(colon + 1))};
  }
  return std::string{trimmed(node.attribute(std::string{name}.c_str()).value())};
}

}  // namespace sim::drawing
