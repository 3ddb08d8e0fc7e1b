#include "host-sim/import/doubled_curves.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <variant>

#include "host-sim/contour/known_rows.hpp"

namespace sim::drawing {
namespace {

std::array<std::int64_t, 8> numbers_of(const Bezier& curve) {
  constexpr double kPerMm = 1.0e7;
  std::array<std::int64_t, 8> numbers{};
  for (std::size_t i = 0; i < curve.points.size(); ++i) {
    numbers[2 * i] = std::llround(kPerMm * curve.points[i].x());
    numbers[2 * i + 1] = std::llround(kPerMm * curve.points[i].y());
  }
  return numbers;
}

}  // namespace

DoubledCurves::Key DoubledCurves::key_of(const Bezier& curve, bool& is_backwards) {
  const Key ahead = numbers_of(curve);
  const Key back = numbers_of(std::get<Bezier>(reversed(Shape{curve})));
  is_backwards = back < ahead;
  return is_backwards ? back : ahead;
}

void DoubledCurves::count(const DrawnContour& contour) {
  bool is_backwards = false;
  for (const Shape& shape : contour.shapes) {
    if (const auto* const curve = std::get_if<Bezier>(&shape)) {
      ++known_[key_of(*curve, is_backwards)].count;
    }
  }
}

/// Returns the arcs along a curve, or the curve itself if no arcs are within the tolerance.
std::vector<Shape> DoubledCurves::arcs_along(const Bezier& curve,
                                             const OutlineOptions& options,
                                             KnownRows& rows) {
  DrawnContour alone;
  alone.shapes = {curve};
  const FittedContour fitted = arcs_of(alone, options, rows);
  if (fitted.fault) return {curve};
  std::vector<Shape> arcs;
  for (std::size_t i = 1; i < fitted.vertices.size(); ++i) {
    const ContourVertex& from = fitted.vertices[i - 1];
    arcs.push_back(bulge_edge(from.point(), fitted.vertices[i].point(), from.bulge));
  }
  return arcs;
}

DrawnContour DoubledCurves::with_arcs(const DrawnContour& contour,
                                      const OutlineOptions& options,
                                      KnownRows& rows) {
  DrawnContour result = contour;
  result.shapes.clear();
  for (const Shape& shape : contour.shapes) {
    const auto* const curve = std::get_if<Bezier>(&shape);
    bool is_backwards = false;
    Known* known = curve != nullptr ? &known_[key_of(*curve, is_backwards)] : nullptr;
    if (known == nullptr || known->count < 2) {
      result.shapes.push_back(shape);
      continue;
    }
    if (known->arcs.empty()) {
      const Shape along = is_backwards ? reversed(shape) : shape;
      known->arcs = arcs_along(std::get<Bezier>(along), options, rows);
    }
    std::vector<Shape> arcs = known->arcs;
    if (is_backwards) {
      std::ranges::reverse(arcs);
      for (Shape& arc : arcs) arc = reversed(std::move(arc));
    }
    std::ranges::move(arcs, std::back_inserter(result.shapes));
  }
  return result;
}

}  // namespace sim::drawing
