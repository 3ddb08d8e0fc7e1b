#include "planner/geometry/bezier_view.hpp"

#include "planner/base/coordinate.hpp"

namespace cnc {
namespace {

struct Value {
  float value;
  float slope;  ///< Derivative with respect to the parameter, divided by the degree.
};

/// Evaluates by De Casteljau's triangle instead of powers of the parameter, because with unequal
/// weights the powers cancel each other.
Value evaluate(std::array<float, Bezier::kHighestDegree + 1> c, std::size_t degree, float t) {
  const float rest = 1.0F - t;
  for (std::size_t last = degree; last > 1; --last) {
    for (std::size_t i = 0; i < last; ++i) c[i] = rest * c[i] + t * c[i + 1];
  }
  return {.value = rest * c[0] + t * c[1], .slope = c[1] - c[0]};
}

}  // namespace

BezierView::BezierView(const Bezier& bezier, const PlanePlace& origin, const Vec2& along)
    : degree_{bezier.degree()} {
  const Wide here_x = to_wide(origin.x);
  const Wide here_y = to_wide(origin.y);
  const Wide along_x{along.x()};
  const Wide along_y{along.y()};
  for (std::size_t i = 0; i <= degree_; ++i) {
    const WeightedPoint& point = bezier.point(i);
    const Wide dx = point.x - point.weight * here_x;
    const Wide dy = point.y - point.weight * here_y;
    x_[i] = (dx * along_x + dy * along_y).to_float() * kMillimetresPerNanometre;
    y_[i] = (dy * along_x - dx * along_y).to_float() * kMillimetresPerNanometre;
    weight_[i] = point.weight.to_float();
  }
}

CurvePoint BezierView::at(float parameter) const {
  const Value x = evaluate(x_, degree_, parameter);
  const Value y = evaluate(y_, degree_, parameter);
  const Value weight = evaluate(weight_, degree_, parameter);
  const float share = 1.0F / weight.value;
  const Vec2 place{x.value * share, y.value * share};
  return {.place = place,
          .direction = {x.slope - place.x() * weight.slope, y.slope - place.y() * weight.slope}};
}

}  // namespace cnc
