#pragma once

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "host-sim/cut/cut_program.hpp"
#include "host-sim/cut/plan.hpp"
#include "tests/host-sim/import/support.hpp"

namespace sim::cut {

inline constexpr double kTestKerf = 0.6;
inline constexpr double kHalf = 0.5 * kTestKerf;

/// Returns the same settings for all layers of a drawing, and a kerf of 0.6 mm.
inline std::vector<LayerPlan> layers_with(const drawing::Drawing& drawn,
                                          const LayerSettings& settings) {
  const LayerPlan layer{settings, {{2000, 1'800'000, 4'000'000}, kTestKerf, 0.01}};
  return std::vector<LayerPlan>(drawn.layers.size(), layer);
}

inline CutPlan plan_of(const drawing::Drawing& drawn, const LayerSettings& settings = {}) {
  return plan_cuts(drawn, layers_with(drawn, settings));
}

/// Returns a plan whose order a test can foresee: always the nearest cut next, each with its usual
/// beginning.
inline CutPlan foreseen_plan_of(const drawing::Drawing& drawn, LayerSettings settings = {}) {
  settings.start = StartAt::kUsual;
  const OrderWish wish{.method = order::OrderMethod::kNearest};
  return plan_cuts(drawn, layers_with(drawn, settings), {}, WayBeside::kHere, {}, wish);
}

/// An outline in the tests' own form, by points: a polygon by its corners, a circle by many points.
using Outline = std::vector<Place>;

inline double distance_to_chord(const Place& a, const Place& b, const Place& place) {
  const Place way = b - a;
  const double square = way.squaredNorm();
  const double share =
      square > 0.0 ? std::clamp(drawing::dot(place - a, way) / square, 0.0, 1.0) : 0.0;
  return drawing::distance(a + share * way, place);
}

/// Returns the distance to the nearest chord of closed outlines, by checking each chord.
inline double distance_to_all(const std::vector<Outline>& outlines, const Place& place) {
  double least = 1.0e9;
  for (const Outline& outline : outlines) {
    for (std::size_t i = 0; i < outline.size(); ++i) {
      const Place& next = outline[(i + 1) % outline.size()];
      least = std::min(least, distance_to_chord(outline[i], next, place));
    }
  }
  return least;
}

/// Returns points along a stroke, at most `every_mm` apart.
inline std::vector<Place> places_along(const Stroke& stroke, double every_mm) {
  const int count = 1 + static_cast<int>(length_of(stroke) / every_mm);
  std::vector<Place> places;
  for (int i = 0; i <= count; ++i) {
    places.push_back(place_at(stroke, static_cast<double>(i) / count));
  }
  return places;
}

}  // namespace sim::cut
