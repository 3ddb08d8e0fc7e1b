#include "tests/planner/contour/nurbs_curve.hpp"

#include <cmath>
#include <limits>

#include "planner/base/contract.hpp"

namespace cnc::contour {
namespace {

/// A control point times its weight, and the weight.
struct Homogeneous {
  WideVec2 place{0.0, 0.0};
  double weight = 0.0;
};

Homogeneous mixed(const Homogeneous& a, const Homogeneous& b, double share) {
  return {(1.0 - share) * a.place + share * b.place, (1.0 - share) * a.weight + share * b.weight};
}

Homogeneous difference(const Homogeneous& a, const Homogeneous& b, double scale) {
  return {scale * (b.place - a.place), scale * (b.weight - a.weight)};
}

bool is_number(double value) { return std::abs(value) <= std::numeric_limits<double>::max(); }

bool all_ascend(std::span<const double> knots) {
  for (std::size_t i = 0; i < knots.size(); ++i) {
    if (!is_number(knots[i]) || (i > 0 && knots[i] < knots[i - 1])) return false;
  }
  return true;
}

/// Returns whether each inner knot has a multiplicity of at most `degree`. Otherwise the curve
/// would have a gap.
bool holds_together(std::span<const double> knots, std::size_t degree) {
  for (std::size_t i = 1; i + degree + 1 < knots.size(); ++i) {
    if (knots[i + degree] <= knots[i]) {
      const bool at_start = i <= degree && knots[i] <= knots[degree];
      const bool at_end = knots[i] >= knots[knots.size() - degree - 1];
      if (!at_start && !at_end) return false;
    }
  }
  return true;
}

}  // namespace

Result<NurbsCurve, NurbsError> NurbsCurve::make(std::size_t degree,
                                                std::span<const WeightedPlace> points,
                                                std::span<const double> knots) {
  if (degree < 1 || degree > kHighestDegree) return NurbsError::kDegree;
  if (points.size() <= degree) return NurbsError::kTooFewPoints;
  if (knots.size() != points.size() + degree + 1) return NurbsError::kKnotCount;
  if (points.size() > std::numeric_limits<std::uint16_t>::max()) return NurbsError::kTooManySpans;
  if (!all_ascend(knots)) return NurbsError::kKnotOrder;
  if (!holds_together(knots, degree)) return NurbsError::kKnotRepeated;
  for (const WeightedPlace& point : points) {
    if (!(point.weight > 0.0) || !is_number(point.weight)) return NurbsError::kWeight;
    if (!is_number(point.place.x()) || !is_number(point.place.y())) return NurbsError::kNotAPlace;
  }
  NurbsCurve curve{degree, points, knots};
  for (std::size_t i = degree; i < points.size(); ++i) {
    if (!(knots[i + 1] > knots[i])) continue;
    if (curve.span_count_ == kMaxSpans) return NurbsError::kTooManySpans;
    curve.spans_[curve.span_count_++] = static_cast<std::uint16_t>(i);
  }
  if (curve.span_count_ == 0) return NurbsError::kKnotRepeated;
  return curve;
}

/// Two steps before de Boor's triangle has narrowed to a point, its remaining differences give the
/// second derivative.
CurveJet NurbsCurve::at(std::size_t span, double share) const {
  CNC_ASSERT(span < span_count_);
  const std::size_t knot = spans_[span];
  const double width = knots_[knot + 1] - knots_[knot];
  const double u =
      share < 0.5 ? knots_[knot] + share * width : knots_[knot + 1] - (1.0 - share) * width;
  std::array<Homogeneous, kHighestDegree + 1> row{};
  for (std::size_t i = 0; i <= degree_; ++i) {
    const WeightedPlace& point = points_[knot - degree_ + i];
    row[i] = {point.weight * point.place, point.weight};
  }
  Homogeneous second{};
  Homogeneous first{};
  for (std::size_t level = 1; level <= degree_; ++level) {
    const std::size_t left = degree_ - level;  // Last index of the next row.
    const auto reach = [&](std::size_t i) {
      return knots_[knot + i + 1] - knots_[knot + i + level - degree_];
    };
    if (left == 1) {
      const double order = static_cast<double>(degree_) * static_cast<double>(level);
      const Homogeneous before = difference(row[0], row[1], 1.0 / reach(0));
      const Homogeneous after = difference(row[1], row[2], 1.0 / reach(1));
      second = difference(before, after, order / width);
    }
    if (left == 0) {
      first = difference(row[0], row[1], static_cast<double>(degree_) / width);
    }
    for (std::size_t i = 0; i <= left; ++i) {
      const double begin = knots_[knot + i + level - degree_];
      row[i] = mixed(row[i], row[i + 1], (u - begin) / reach(i));
    }
  }
  // Uses the quotient rule, with the fraction of the span instead of the knots' parameter.
  const double inverse = 1.0 / row[0].weight;
  CurveJet jet{};
  jet.place = inverse * row[0].place;
  const WideVec2 slope = inverse * (first.place - first.weight * jet.place);
  const WideVec2 bend =
      inverse * (second.place - 2.0 * first.weight * slope - second.weight * jet.place);
  jet.first = width * slope;
  jet.second = width * width * bend;
  return jet;
}

}  // namespace cnc::contour
