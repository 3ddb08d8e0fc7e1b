#pragma once

#include <algorithm>
#include <array>
#include <cmath>

#include "planner/geometry/spline.hpp"
#include "tests/support/random_source.hpp"

namespace cnc::exact {

struct Knob {
  double x;
  double y;
};

inline PlanePlace in_nanometres(const Knob& place) {
  return {std::llround(place.x * 1.0e6), std::llround(place.y * 1.0e6)};
}

/// Returns a cubic from its four control points in mm, the first at the origin.
inline Spline cubic(const std::array<Knob, 4>& points) {
  Spline spline;
  spline.set_order(4);
  for (const Knob& point : points) {
    spline.append({.place = in_nanometres({point.x - points[0].x, point.y - points[0].y})});
  }
  return spline;
}

/// Returns a cubic of any kind, a micrometre to a metre wide: random, nearly straight, with
/// coincident control points, a loop, a cusp or an inflection, reversing on a line, or a gentle
/// arc.
inline Spline random_cubic(proof::Random& random) {
  const double size = random.magnitude(1.0e-3, 1.0e3);
  const auto anywhere = [&] { return Knob{random.between(-1.0, 1.0), random.between(-1.0, 1.0)}; };
  std::array<Knob, 4> p{anywhere(), anywhere(), anywhere(), anywhere()};
  switch (random.below(9)) {
    case 0: {  // Nearly straight.
      const double width = random.magnitude(1.0e-8, 1.0e-1);
      for (Knob& point : p) point.y *= width;
      std::ranges::sort(p, {}, &Knob::x);
      break;
    }
    case 1:  // Coincident control points.
      p[random.below(4)] = p[random.below(4)];
      if (random.chance(0.3)) p[random.below(4)] = p[random.below(4)];
      break;
    case 2: {  // A cusp at t: C'(t) = 0 fixes the last control point.
      const double t = random.between(0.2, 0.8);
      const double s = 1.0 - t;
      p[3] = {p[2].x - (s * s * (p[1].x - p[0].x) + 2.0 * s * t * (p[2].x - p[1].x)) / (t * t),
              p[2].y - (s * s * (p[1].y - p[0].y) + 2.0 * s * t * (p[2].y - p[1].y)) / (t * t)};
      break;
    }
    case 3:  // A loop.
      p = {{{-1.0, 0.0},
            {random.between(0.5, 4.0), 1.0},
            {random.between(-4.0, -0.5), 1.0},
            {1.0, random.between(-0.3, 0.3)}}};
      break;
    case 4:  // An S.
      p = {{{-1.0, 0.0},
            {random.between(-0.5, 1.0), 1.0},
            {random.between(-1.0, 0.5), -1.0},
            {1.0, 0.0}}};
      break;
    case 5:  // Back and forth on one line.
      for (Knob& point : p) point.y = 0.5 * point.x;
      break;
    case 6: {  // Close to an arc.
      const double sweep = random.between(0.1, 3.0);
      const double arm = 4.0 / 3.0 * std::tan(sweep / 4.0) * random.between(0.8, 1.2);
      p = {{{1.0, 0.0},
            {1.0, arm},
            {std::cos(sweep) + arm * std::sin(sweep), std::sin(sweep) - arm * std::cos(sweep)},
            {std::cos(sweep), std::sin(sweep)}}};
      break;
    }
    default:
      break;
  }
  const double angle = random.between(-3.2, 3.2);
  const double c = size * std::cos(angle);
  const double s = size * std::sin(angle);
  for (Knob& point : p) point = {c * point.x - s * point.y, s * point.x + c * point.y};
  return cubic(p);
}

/// Returns a spline with any order, number of control points and weights.
inline Spline random_spline(proof::Random& random) {
  Spline spline;
  spline.set_order(Spline::kLowestOrder +
                   random.below(Spline::kHighestOrder - Spline::kLowestOrder + 1));
  const std::size_t count = spline.order() + random.below(12);
  const double size = random.magnitude(1.0e-1, 3.0e2);
  const bool weighted = random.chance(0.6);
  const bool course = random.chance(0.5);
  Knob place{0.0, 0.0};
  for (std::size_t i = 0; i < count; ++i) {
    const auto weight = weighted ? static_cast<float>(random.magnitude(0.1, 10.0)) : 1.0F;
    spline.append({.place = in_nanometres(place), .weight = weight});
    if (course) {
      place = {place.x + size * random.between(0.2, 1.0),
               place.y + size * random.between(-1.0, 1.0)};
    } else {
      place = {size * random.between(-1.0, 1.0), size * random.between(-1.0, 1.0)};
    }
  }
  return spline;
}

}  // namespace cnc::exact
