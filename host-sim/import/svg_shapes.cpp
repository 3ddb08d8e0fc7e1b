#include "host-sim/import/svg_shapes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace sim::drawing {
namespace {

/// Reads lengths of one element, and stores the error about the first attribute that is no length.
class LengthReader {
 public:
  LengthReader(const SvgProperties& properties, const SvgViewport& viewport)
      : properties_{properties}, viewport_{viewport} {}

  /// Returns the length of an attribute; nothing if the attribute is missing, `auto` or no length.
  std::optional<double> find(const char* name, SvgDirection direction) {
    const std::string_view text = properties_.get(name);
    if (!properties_.has(name) || text == "auto") return {};
    const auto length = svg_length(text, viewport_, direction);
    if (!length && wrong_.empty()) wrong_ = fmt::format("{}=\"{}\" is no length", name, text);
    return length;
  }
  double get(const char* name, SvgDirection direction) {
    return find(name, direction).value_or(0.0);
  }

  /// Returns an attribute that is a size or radius. A value below 0 is an error, too.
  double size(const char* name, SvgDirection direction) {
    const double length = get(name, direction);
    if (length < 0.0 && wrong_.empty()) wrong_ = fmt::format("{} is below 0", name);
    return length;
  }

  /// Stores a note about a shape without area. Nothing is drawn for it, which is probably not
  /// intended.
  void need_area(const char* what, bool has_area) {
    if (has_area || !wrong_.empty()) return;
    wrong_ = fmt::format("{} is 0: it has no area", what);
    is_nothing_ = true;
  }

  [[nodiscard]] const std::string& wrong() const { return wrong_; }
  [[nodiscard]] bool is_nothing() const { return is_nothing_; }

 private:
  const SvgProperties& properties_;
  const SvgViewport& viewport_;
  std::string wrong_;
  bool is_nothing_ = false;
};

constexpr SvgDirection kX = SvgDirection::kAcross;
constexpr SvgDirection kY = SvgDirection::kUpright;
constexpr SvgDirection kR = SvgDirection::kOther;

void draw_rect(LengthReader& read, SvgPen& pen) {
  const Place a{read.get("x", kX), read.get("y", kY)};
  const Place size{read.size("width", kX), read.size("height", kY)};
  const auto given_rx = read.find("rx", kX);
  const auto given_ry = read.find("ry", kY);
  read.need_area("width or height", size.x() > 0.0 && size.y() > 0.0);
  if (!read.wrong().empty()) return;
  const double rx = std::clamp(given_rx.value_or(given_ry.value_or(0.0)), 0.0, 0.5 * size.x());
  const double ry = std::clamp(given_ry.value_or(given_rx.value_or(0.0)), 0.0, 0.5 * size.y());
  const Place b = a + size;
  const Place r{rx, ry};
  const bool sharp = rx == 0.0 || ry == 0.0;
  const Place in = sharp ? Place{0.0, 0.0} : r;
  const auto corner = [&](const Place& end) {
    if (!sharp) pen.arc_to(r, 0.0, false, true, end);
  };
  pen.move_to({a.x() + in.x(), a.y()});
  pen.line_to({b.x() - in.x(), a.y()});
  corner({b.x(), a.y() + in.y()});
  pen.line_to({b.x(), b.y() - in.y()});
  corner({b.x() - in.x(), b.y()});
  pen.line_to({a.x() + in.x(), b.y()});
  corner({a.x(), b.y() - in.y()});
  pen.line_to({a.x(), a.y() + in.y()});
  corner({a.x() + in.x(), a.y()});
  pen.close();
}

void draw_round(LengthReader& read, bool circle, SvgPen& pen) {
  const Place centre{read.get("cx", kX), read.get("cy", kY)};
  if (circle) {
    const double radius = read.size("r", kR);
    read.need_area("r", radius > 0.0);
    if (read.wrong().empty()) pen.add(arc_of(centre, radius, 0.0, kFullTurn));
    return;
  }
  const auto rx = read.find("rx", kX);
  const auto ry = read.find("ry", kY);
  const Place radii{rx.value_or(ry.value_or(0.0)), ry.value_or(rx.value_or(0.0))};
  read.need_area("rx or ry", radii.x() > 0.0 && radii.y() > 0.0);
  if (!read.wrong().empty()) return;
  const Ellipse whole{centre, {radii.x(), 0.0}, {0.0, radii.y()}, 0.0, kFullTurn};
  pen.add(transformed(whole, {}));
}

}  // namespace

bool is_svg_shape(std::string_view name) {
  static constexpr std::array<std::string_view, 7> kNames{
      "path", "rect", "circle", "ellipse", "line", "polyline", "polygon"};
  return std::ranges::find(kNames, name) != kNames.end();
}

SvgShapeFault draw_svg_shape(std::string_view name,
                             const SvgProperties& properties,
                             const SvgViewport& viewport,
                             SvgPen& pen) {
  if (name == "path") return {draw_path(properties.attribute("d"), pen)};
  if (name == "polyline" || name == "polygon") {
    return {draw_points(properties.attribute("points"), name == "polygon", pen)};
  }
  LengthReader read{properties, viewport};
  if (name == "rect") {
    draw_rect(read, pen);
  } else if (name == "line") {
    pen.move_to({read.get("x1", kX), read.get("y1", kY)});
    pen.line_to({read.get("x2", kX), read.get("y2", kY)});
  } else {
    draw_round(read, name == "circle", pen);
  }
  return {read.wrong(), !read.is_nothing()};
}

Place svg_place(const SvgProperties& properties, const SvgViewport& viewport) {
  const auto length = [&](const char* name, SvgDirection direction) {
    return svg_length(properties.get(name), viewport, direction).value_or(0.0);
  };
  return {length("x", SvgDirection::kAcross), length("y", SvgDirection::kUpright)};
}

}  // namespace sim::drawing
