#include "host-sim/import/curve.hpp"

#include <algorithm>
#include <utility>

namespace sim::drawing {
namespace {

// Least height of an arc above its chord, mm. Flatter arcs become lines. This bound is a hundredth
// of the finest step of a machine.
constexpr double kFlatMm = 1.0e-6;

/// Returns an ellipse, or an arc if the ellipse is a circle.
Shape rounded(const Ellipse& ellipse) {
  const Transform axes{.x_axis = ellipse.major, .y_axis = ellipse.minor, .origin = ellipse.centre};
  if (!axes.keeps_circles()) return ellipse;
  const double sweep = ellipse.to - ellipse.from;
  return Arc{axes(direction(ellipse.from)),
             axes(direction(ellipse.to)),
             ellipse.centre,
             axes.determinant() < 0.0 ? -sweep : sweep};
}

struct Mapper {
  const Transform& map;

  Shape operator()(const Line& line) const { return Line{map(line.start), map(line.end)}; }
  Shape operator()(const Arc& arc) const {
    if (map.keeps_circles()) {
      const double sweep = map.determinant() < 0.0 ? -arc.sweep : arc.sweep;
      return Arc{map(arc.start), map(arc.end), map(arc.centre), sweep};
    }
    const Place radius = arc.start - arc.centre;
    const Place left{-radius.y(), radius.x()};
    return Ellipse{map(arc.centre), map.way(radius), map.way(left), 0.0, arc.sweep};
  }
  Shape operator()(const Ellipse& ellipse) const {
    return rounded({map(ellipse.centre),
                    map.way(ellipse.major),
                    map.way(ellipse.minor),
                    ellipse.from,
                    ellipse.to});
  }
  Shape operator()(Bezier curve) const {
    for (Place& point : curve.points) point = map(point);
    return curve;
  }
  Shape operator()(Nurbs curve) const {
    for (Place& point : curve.points) point = map(point);
    return curve;
  }
};

struct Reverser {
  Shape operator()(const Line& line) const { return Line{line.end, line.start}; }
  Shape operator()(const Arc& arc) const { return Arc{arc.end, arc.start, arc.centre, -arc.sweep}; }
  Shape operator()(Ellipse ellipse) const {
    std::swap(ellipse.from, ellipse.to);
    return ellipse;
  }
  Shape operator()(Bezier curve) const {
    std::ranges::reverse(curve.points);
    return curve;
  }
  Shape operator()(Nurbs curve) const {
    std::ranges::reverse(curve.points);
    std::ranges::reverse(curve.weights);
    std::ranges::reverse(curve.knots);
    for (double& knot : curve.knots) knot = -knot;
    const std::size_t last = curve.knots.size() - 2;
    std::ranges::reverse(curve.spans);
    for (std::size_t& knot : curve.spans) knot = last - knot;
    return curve;
  }
};

}  // namespace

std::string_view name_of(const Shape& shape) {
  static constexpr std::array<std::string_view, 5> kNames{
      "line", "arc", "ellipse", "bezier", "spline"};
  return kNames.at(shape.index());
}

Shape bulge_edge(const Place& start, const Place& end, double bulge) {
  const Place chord = end - start;
  if (std::abs(bulge) * 0.5 * chord.norm() < kFlatMm) return Line{start, end};
  // The centre is left of the middle of the chord by chord/2 · (1 - b²) / (2 b), for the bulge b.
  const Place left{-chord.y(), chord.x()};
  const Place centre = 0.5 * (start + end) + left * ((1.0 - bulge * bulge) / (4.0 * bulge));
  return Arc{start, end, centre, 4.0 * std::atan(bulge)};
}

Arc arc_of(const Place& centre, double radius, double from, double sweep) {
  const Place start = centre + radius * direction(from);
  const bool full = std::abs(sweep) >= kFullTurn;
  const Place end = full ? start : Place{centre + radius * direction(from + sweep)};
  return {start, end, centre, std::clamp(sweep, -kFullTurn, kFullTurn)};
}

Place start_of(const Shape& shape) {
  if (const auto* const line = std::get_if<Line>(&shape)) return line->start;
  if (const auto* const arc = std::get_if<Arc>(&shape)) return arc->start;
  return jet(shape, 0, 0.0).place;
}

Place end_of(const Shape& shape) {
  if (const auto* const line = std::get_if<Line>(&shape)) return line->end;
  if (const auto* const arc = std::get_if<Arc>(&shape)) return arc->end;
  if (const auto* const ellipse = std::get_if<Ellipse>(&shape)) {
    // A full ellipse must end exactly at its start, without rounding.
    if (std::abs(ellipse->to - ellipse->from) >= kFullTurn) return start_of(shape);
  }
  return jet(shape, span_count(shape) - 1, 1.0).place;
}

Shape reversed(Shape shape) { return std::visit(Reverser{}, std::move(shape)); }

Shape transformed(const Shape& shape, const Transform& transform) {
  return std::visit(Mapper{transform}, shape);
}

}  // namespace sim::drawing
