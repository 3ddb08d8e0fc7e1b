#include <algorithm>
#include <utility>

#include "host-sim/import/curve.hpp"

namespace sim::drawing {
namespace {

std::size_t turn_spans(double sweep) {
  // With eight spans per full turn, the quadrature in length_of() is accurate enough.
  return static_cast<std::size_t>(std::max(1.0, std::ceil(std::abs(sweep) * 8.0 / kFullTurn)));
}

/// A point in homogeneous coordinates: the point multiplied by its weight, and the weight.
struct Homogeneous {
  Place place;
  double weight;
};

Homogeneous mixed(const Homogeneous& a, const Homogeneous& b, double share) {
  return {a.place * (1.0 - share) + b.place * share, a.weight * (1.0 - share) + b.weight * share};
}

Homogeneous difference(const Homogeneous& from, const Homogeneous& to, double scale) {
  return {(to.place - from.place) * scale, (to.weight - from.weight) * scale};
}

/// Computes a point and its derivatives from homogeneous coordinates and their derivatives, by the
/// quotient rule.
Jet projected(const Homogeneous& at, const Homogeneous& first, const Homogeneous& second) {
  const Place place = at.place / at.weight;
  const Place slope = (first.place - place * first.weight) / at.weight;
  return {place,
          slope,
          (second.place - slope * (2.0 * first.weight) - place * second.weight) / at.weight};
}

/// Computes a point and its derivatives by de Boor's algorithm in homogeneous coordinates. The
/// derivatives are differences of the columns one and two steps before the last column of the
/// triangle.
Jet nurbs_jet(const Nurbs& curve, std::size_t knot, double share) {
  const std::size_t degree = curve.degree;
  const double width = curve.knots[knot + 1] - curve.knots[knot];
  const double at = curve.knots[knot] + width * share;
  const auto low = [&](std::size_t i) { return curve.knots[knot - degree + i]; };
  std::array<Homogeneous, kHighestDegree + 1> points{};
  for (std::size_t i = 0; i <= degree; ++i) {
    const std::size_t source = knot - degree + i;
    points[i] = {curve.points[source] * curve.weights[source], curve.weights[source]};
  }
  Homogeneous rise{{0.0, 0.0}, 0.0};
  Homogeneous bend{{0.0, 0.0}, 0.0};
  for (std::size_t level = 1; level <= degree; ++level) {
    const auto reach = [&](std::size_t i) { return curve.knots[knot + 1 + i - level] - low(i); };
    if (level + 1 == degree) {
      const auto before =
          difference(points[degree - 2], points[degree - 1], 1.0 / reach(degree - 1));
      const auto after = difference(points[degree - 1], points[degree], 1.0 / reach(degree));
      const double order = static_cast<double>(degree * level);
      bend = difference(before, after, order * width);
    }
    if (level == degree) {
      const double slope = static_cast<double>(degree) * width / reach(degree);
      rise = difference(points[degree - 1], points[degree], slope);
    }
    for (std::size_t i = degree; i >= level; --i) {
      points[i] = mixed(points[i - 1], points[i], (at - low(i)) / reach(i));
    }
  }
  return projected(points[degree], rise, bend);
}

Jet bezier_jet(const Bezier& curve, double t) {
  const auto& p = curve.points;
  const double s = 1.0 - t;
  return {
      p[0] * (s * s * s) + p[1] * (3.0 * s * s * t) + p[2] * (3.0 * s * t * t) + p[3] * (t * t * t),
      (p[1] - p[0]) * (3.0 * s * s) + (p[2] - p[1]) * (6.0 * s * t) + (p[3] - p[2]) * (3.0 * t * t),
      (p[2] - 2.0 * p[1] + p[0]) * (6.0 * s) + (p[3] - 2.0 * p[2] + p[1]) * (6.0 * t)};
}

Jet ellipse_jet(const Ellipse& ellipse, double share) {
  const double sweep = ellipse.to - ellipse.from;
  const Place turn = direction(ellipse.from + sweep * share);
  const Place outward = ellipse.major * turn.x() + ellipse.minor * turn.y();
  return {ellipse.centre + outward,
          (ellipse.minor * turn.x() - ellipse.major * turn.y()) * sweep,
          outward * (-sweep * sweep)};
}

Jet arc_jet(const Arc& arc, double share) {
  const Place radius = arc.start - arc.centre;
  return ellipse_jet({arc.centre, radius, {-radius.y(), radius.x()}, 0.0, arc.sweep}, share);
}

bool rises(const std::vector<double>& knots, std::size_t degree) {
  for (std::size_t i = 1; i < knots.size(); ++i) {
    if (!(knots[i] >= knots[i - 1])) return false;
  }
  // degree + 1 equal inner knots would divide the curve into two.
  for (std::size_t i = 1; i + degree + 1 < knots.size(); ++i) {
    if (!(knots[i + degree] > knots[i])) return false;
  }
  return true;
}

}  // namespace

std::optional<Nurbs> nurbs(std::size_t degree,
                           std::vector<Place> points,
                           std::vector<double> weights,
                           std::vector<double> knots) {
  if (degree < 1 || degree > kHighestDegree || points.size() > kMaxControlPoints) return {};
  if (points.size() <= degree || knots.size() != points.size() + degree + 1) return {};
  if (weights.empty()) weights.assign(points.size(), 1.0);
  if (weights.size() != points.size()) return {};
  const auto positive = [](double weight) { return weight > 0.0 && std::isfinite(weight); };
  const auto number = [](double knot) { return std::isfinite(knot); };
  if (!std::ranges::all_of(weights, positive) || !std::ranges::all_of(knots, number)) return {};
  if (!std::ranges::all_of(points, is_finite) || !rises(knots, degree)) return {};
  std::vector<std::size_t> spans;
  for (std::size_t knot = degree; knot < points.size(); ++knot) {
    if (knots[knot] < knots[knot + 1]) spans.push_back(knot);
  }
  if (spans.empty()) return {};
  return Nurbs{degree, std::move(points), std::move(weights), std::move(knots), std::move(spans)};
}

bool finite(const Shape& shape) {
  if (const auto* const curve = std::get_if<Nurbs>(&shape)) {
    return std::ranges::all_of(curve->points, is_finite);
  }
  if (const auto* const curve = std::get_if<Bezier>(&shape)) {
    return std::ranges::all_of(curve->points, is_finite);
  }
  if (const auto* const arc = std::get_if<Arc>(&shape)) {
    return is_finite(arc->start) && is_finite(arc->end) && is_finite(arc->centre) &&
           std::isfinite(arc->sweep);
  }
  return is_finite(start_of(shape)) && is_finite(end_of(shape));
}

std::size_t span_count(const Shape& shape) {
  if (const auto* const arc = std::get_if<Arc>(&shape)) return turn_spans(arc->sweep);
  if (const auto* const ellipse = std::get_if<Ellipse>(&shape)) {
    return turn_spans(ellipse->to - ellipse->from);
  }
  const auto* const curve = std::get_if<Nurbs>(&shape);
  return curve == nullptr ? 1 : curve->spans.size();
}

Jet jet(const Shape& shape, std::size_t span, double share) {
  if (const auto* const line = std::get_if<Line>(&shape)) {
    const Place way = line->end - line->start;
    return {line->start + way * share, way, {0.0, 0.0}};
  }
  if (const auto* const curve = std::get_if<Bezier>(&shape)) return bezier_jet(*curve, share);
  if (const auto* const curve = std::get_if<Nurbs>(&shape)) {
    return nurbs_jet(*curve, curve->spans[span], share);
  }
  const auto count = static_cast<double>(span_count(shape));
  const double whole = (static_cast<double>(span) + share) / count;
  const auto* const arc = std::get_if<Arc>(&shape);
  Jet found = arc != nullptr ? arc_jet(*arc, whole) : ellipse_jet(std::get<Ellipse>(shape), whole);
  found.first /= count;
  found.second /= count * count;
  return found;
}

}  // namespace sim::drawing
