#include "host-sim/surface/patch/bezier_patch.hpp"

namespace sim::surface::patch {
namespace {

using Eigen::Vector3d;
using Four = std::array<Vector3d, 4>;

/// Returns the blossom (polar form) of a cubic, by de Casteljau's algorithm with a separate
/// parameter for each step.
Vector3d blossom(const Four& controls, double first, double second, double third) {
  const auto between = [](const Vector3d& a, const Vector3d& b, double t) -> Vector3d {
    return (1.0 - t) * a + t * b;
  };
  const Vector3d a = between(controls[0], controls[1], first);
  const Vector3d b = between(controls[1], controls[2], first);
  const Vector3d c = between(controls[2], controls[3], first);
  return between(between(a, b, second), between(b, c, second), third);
}

Four part_of(const Four& controls, Interval interval) {
  const auto [a, b] = interval;
  return {blossom(controls, a, a, a),
          blossom(controls, a, a, b),
          blossom(controls, a, b, b),
          blossom(controls, b, b, b)};
}

/// Returns the values of the Bernstein polynomials of degree 3 at `t`.
std::array<double, 4> weights(double t) {
  const double s = 1.0 - t;
  return {s * s * s, 3.0 * s * s * t, 3.0 * s * t * t, t * t * t};
}

/// Returns the derivatives of the Bernstein polynomials of degree 3 at `t`.
std::array<double, 4> slope_weights(double t) {
  const double s = 1.0 - t;
  return {-3.0 * s * s, 3.0 * s * (s - 2.0 * t), 3.0 * t * (2.0 * s - t), 3.0 * t * t};
}

Vector3d weighted(const Four& controls, const std::array<double, 4>& by) {
  return by[0] * controls[0] + by[1] * controls[1] + by[2] * controls[2] + by[3] * controls[3];
}

}  // namespace

Vector3d BezierCurve::at(double t) const { return weighted(controls, weights(t)); }

BezierCurve BezierCurve::part(Interval interval) const { return {part_of(controls, interval)}; }

Vector3d BezierPatch::at(double u, double v) const { return curve_at_u(u).at(v); }

PatchJet BezierPatch::jet(double u, double v) const {
  const std::array<double, 4> value = weights(v);
  const std::array<double, 4> slope = slope_weights(v);
  Four points{};
  Four slopes{};
  for (std::size_t i = 0; i < 4; ++i) {
    points[i] = weighted(rows[i].controls, value);
    slopes[i] = weighted(rows[i].controls, slope);
  }
  const std::array<double, 4> across = weights(u);
  const std::array<double, 4> slope_across = slope_weights(u);
  return {.point = weighted(points, across),
          .along_u = weighted(points, slope_across),
          .along_v = weighted(slopes, across),
          .twist = weighted(slopes, slope_across)};
}

BezierCurve BezierPatch::curve_at_u(double u) const {
  const std::array<double, 4> by = weights(u);
  BezierCurve curve;
  for (std::size_t j = 0; j < 4; ++j) {
    curve.controls[j] = by[0] * control(0, j) + by[1] * control(1, j) + by[2] * control(2, j) +
                        by[3] * control(3, j);
  }
  return curve;
}

BezierCurve BezierPatch::curve_at_v(double v) const { return transposed().curve_at_u(v); }

BezierPatch BezierPatch::part(Interval u, Interval v) const {
  BezierPatch across = transposed();
  for (BezierCurve& row : across.rows) row = row.part(u);
  BezierPatch result = across.transposed();
  for (BezierCurve& row : result.rows) row = row.part(v);
  return result;
}

BezierPatch BezierPatch::transposed() const {
  BezierPatch result;
  for (std::size_t u = 0; u < 4; ++u) {
    for (std::size_t v = 0; v < 4; ++v) result.rows[v].controls[u] = control(u, v);
  }
  return result;
}

}  // namespace sim::surface::patch
