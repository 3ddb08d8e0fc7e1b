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
  if (call.count == 1 && call.name == "translateX") return moved_by({v[0], 0.0});
  if (call.count == 1 && call.name == "translateY") return moved_by({0.0, v[0]});
  if (call.count == 1 && call.name == "scaleX") return scaled_by(v[0], 1.0);
  if (call.count == 1 && call.name == "scaleY") return scaled_by(1.0, v[0]);
  if (call.name == "skewX" && call.count == 1) {
    return Transform{.y_axis{std::tan(v[0] * kRadiansPerDegree), 1.0}};
  }
  if (call.name == "skewY" && call.count == 1) {
    return Transform{.x_axis{1.0, std::tan(v[0] * kRadiansPerDegree)}};
  }
  return {};
}

/// Returns the factor from a unit of transforms in style sheets to px or degrees; nothing for an
/// unknown unit.
std::optional<double> factor_of(std::string_view unit) {
  if (unit == "deg") return 1.0;
  if (unit == "rad") return 1.0 / kRadiansPerDegree;
  if (unit == "grad") return 0.9;
  if (unit == "turn") return 360.0;
  return px_per(unit);
}

std::optional<TransformCall> next_call(Scanner& scanner) {
  TransformCall call;
  call.name = scanner.word();
  if (!scanner.take('(')) return {};
  while (!scanner.take(')')) {
    const auto value = scanner.number();
    if (!value || call.count == call.values.size()) return {};
    const char next = scanner.peek();
    const bool has_unit = next >= 'a' && next <= 'z';
    const auto factor = factor_of(has_unit ? scanner.word() : std::string_view{});
    if (!factor) return {};
    call.values[call.count++] = *value * *factor;
    scanner.separate();
  }
  return call;
}

/// Returns the share of the free space that an alignment (Min, Mid or Max) leaves before the box.
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
  if (unit == "em" || unit == "rem") return *value * viewport.em;
  if (unit == "ex" || unit == "ch") return *value * 0.5 * viewport.em;
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

std::optional<Place> svg_origin(std::string_view text, const SvgViewport& viewport) {
  static constexpr std::array<std::pair<std::string_view, double>, 3> kAcross{
      {{"left", 0.0}, {"center", 0.5}, {"right", 1.0}}};
  static constexpr std::array<std::pair<std::string_view, double>, 3> kUpright{
      {{"top", 0.0}, {"center", 0.5}, {"bottom", 1.0}}};
  const std::string_view all = trimmed(text);
  std::string_view x = all.substr(0, all.find_first_of(" \t\r\n"));
  std::string_view y = trimmed(all.substr(x.size()));
  // A third word would be the depth (z), which is ignored.
  y = y.substr(0, y.find_first_of(" \t\r\n"));
  if (y.empty()) y = "center";
  const auto is_upright = [](std::string_view word) { return word == "top" || word == "bottom"; };
  if (is_upright(x) || y == "left" || y == "right") std::swap(x, y);
  const auto place =
      [&](std::string_view word, const auto& words, double size, SvgDirection direction) {
        const auto* const found =
            std::ranges::find(words, word, [](const auto& w) { return w.first; });
        if (found != words.end()) return std::optional{found->second * size};
        return svg_length(word, viewport, direction);
      };
  const auto across = place(x, kAcross, viewport.width, SvgDirection::kAcross);
  const auto upright = place(y, kUpright, viewport.height, SvgDirection::kUpright);
  if (!across || !upright) return {};
  return Place{*across, *upright};
}

}  // namespace sim::drawing
