#include "host-sim/measure/programmed_spline.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

namespace sim {
namespace {

double knot_of(const ProgrammedSpline& spline, std::size_t index) {
  const double inner = static_cast<double>(index) - static_cast<double>(spline.order - 1);
  return std::clamp(inner, 0.0, static_cast<double>(spline.points.size() - spline.order + 1));
}

/// Returns the basis functions that are not zero at a parameter within the span `span` of knots.
/// Their number is the order. The first one belongs to the control point `span`.
std::vector<double> basis(const ProgrammedSpline& spline, std::size_t span, double parameter) {
  std::vector<double> values{1.0};
  for (std::size_t order = 2; order <= spline.order; ++order) {
    std::vector<double> next(order, 0.0);
    for (std::size_t i = 0; i < values.size(); ++i) {
      const std::size_t first = span + spline.order + i - values.size();
      const double left = knot_of(spline, first);
      const double share = (parameter - left) / (knot_of(spline, first + order - 1) - left);
      next[i] += (1.0 - share) * values[i];
      next[i + 1] += share * values[i];
    }
    values = next;
  }
  return values;
}

struct Circle3 {
  std::array<double, 2> centre;
  double radius;
  bool clockwise;
};

/// Returns the circle through three points; none if the points are on a line.
std::optional<Circle3> circle_through(const Point& a, const Point& b, const Point& c) {
  const double bx = b[0] - a[0];
  const double by = b[1] - a[1];
  const double cx = c[0] - a[0];
  const double cy = c[1] - a[1];
  const double cross = bx * cy - by * cx;
  const double chord = std::hypot(cx, cy);
  if (std::abs(cross) < 1.0e-9 * chord * chord || chord <= 0.0) return std::nullopt;
  const double b2 = bx * bx + by * by;
  const double c2 = cx * cx + cy * cy;
  const double x = (cy * b2 - by * c2) / (2.0 * cross);
  const double y = (bx * c2 - cx * b2) / (2.0 * cross);
  return Circle3{{a[0] + x, a[1] + y}, std::hypot(x, y), cross < 0.0};
}

/// Divides parameter ranges until each piece is as close to the curve as required.
class Divider {
 public:
  explicit Divider(const ProgrammedSpline& spline) : spline_{spline} {}

  void divide(double from, double to) {
    // Ends of the remaining pieces; the end of the next piece is the last item.
    std::vector<double> ends{to};
    while (!ends.empty()) {
      const double end = ends.back();
      const Curve piece = piece_between(from, end);
      if (end - from > kShortest && !is_close(piece, from, end)) {
        ends.push_back(0.5 * (from + end));
        continue;
      }
      pieces.push_back(piece);
      from = end;
      ends.pop_back();
    }
  }

  std::vector<Curve> pieces;

 private:
  static constexpr double kShortest = 1.0e-9;

  [[nodiscard]] Curve piece_between(double from, double to) const {
    const Point start = point_of(spline_, from);
    const Point middle = point_of(spline_, 0.5 * (from + to));
    const Point end = point_of(spline_, to);
    const auto circle = circle_through(start, middle, end);
    if (!circle) return Curve::line(start, end);
    return Curve::arc(start, end, cnc::Plane::kXY, circle->centre, circle->clockwise);
  }

  [[nodiscard]] bool is_close(const Curve& piece, double from, double to) const {
    constexpr double kSafety = 0.5;
    if (piece.length() > 1.2 * distance(piece.start(), piece.end())) return false;
    for (const double share : {0.1, 0.25, 0.5, 0.75, 0.9}) {
      const Point point = point_of(spline_, from + share * (to - from));
      if (piece.nearest(point).distance > kSafety * kSplinePieceError) return false;
    }
    return true;
  }

  const ProgrammedSpline& spline_;
};

}  // namespace

Point ProgrammedSpline::end() const {
  Point place = start;
  place[0] = points.back()[0];
  place[1] = points.back()[1];
  return place;
}

Point point_of(const ProgrammedSpline& spline, double parameter) {
  const std::size_t spans = spline.points.size() - spline.order + 1;
  const auto whole = static_cast<std::size_t>(std::max(0.0, parameter));
  const std::size_t span = std::min(whole, spans - 1);
  const std::vector<double> values = basis(spline, span, parameter);
  double weight = 0.0;
  Point point = spline.start;
  point[0] = point[1] = 0.0;
  for (std::size_t i = 0; i < spline.order; ++i) {
    const double part = values[i] * spline.weights[span + i];
    weight += part;
    point[0] += part * spline.points[span + i][0];
    point[1] += part * spline.points[span + i][1];
  }
  point[0] /= weight;
  point[1] /= weight;
  return point;
}

std::vector<Curve> pieces_of(const ProgrammedSpline& spline) {
  // In so short a part, every deviation from an arc shows at the samples.
  constexpr int kParts = 8;
  Divider divider{spline};
  const std::size_t spans = spline.points.size() - spline.order + 1;
  for (std::size_t span = 0; span < spans; ++span) {
    for (int part = 0; part < kParts; ++part) {
      const double from = static_cast<double>(span) + static_cast<double>(part) / kParts;
      divider.divide(from, from + 1.0 / kParts);
    }
  }
  return divider.pieces;
}

}  // namespace sim
