#include "host-sim/surface/path/ramp_entry.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "host-sim/cut/stroke.hpp"

namespace sim::surface {
namespace {

using Eigen::Vector3d;

/// Height of the ramp above the run, mm. It exceeds the deviation of the ramp's lines from the
/// run's arcs, so that the ramp is nowhere below the run.
constexpr double kAboveMm = 0.02;
/// Minimum length in plan, mm, of a run above which a ramp is possible.
constexpr double kMinLengthMm = 0.2;

/// A position of the tip on the run, and its distance in plan along the run, mm.
struct RampPlace {
  Vector3d tip = Vector3d::Zero();
  double way = 0.0;
};

/// Adds positions of a stretch up to the distance `max_way` in plan. Lines between the positions
/// deviate from the stretch's arcs by at most half of kAboveMm.
void add_places(const SurfaceStretch& stretch, double max_way, std::vector<RampPlace>& places) {
  for (std::size_t i = 0; i + 1 < stretch.vertices.size(); ++i) {
    const ContourVertex& from = stretch.vertices[i];
    const ContourVertex& to = stretch.vertices[i + 1];
    const cut::Stroke stroke{.from = {from.x, from.y}, .to = {to.x, to.y}, .bulge = from.bulge};
    const double height = 0.5 * std::abs(stroke.bulge) * cut::length_of(stroke);
    const double parts = std::max(1.0, std::ceil(std::sqrt(2.0 * height / kAboveMm)));
    for (double part = 1.0; part <= parts; part += 1.0) {
      const RampPlace last = places.back();
      const cut::Place seen = cut::place_at(stroke, part / parts);
      const Vector3d tip = stretch.place_of({seen.x(), seen.y(), 0.0});
      const double step = (tip - last.tip).head<2>().norm();
      const double left = max_way - last.way;
      if (step >= left) {
        places.push_back({last.tip + left / step * (tip - last.tip), max_way});
        return;
      }
      places.push_back({tip, last.way + step});
    }
  }
}

/// Returns positions of a run up to the distance `max_way` in plan, or of the complete run if it is
/// shorter.
std::vector<RampPlace> places_up_to(std::span<const SurfaceStretch> run, double max_way) {
  std::vector<RampPlace> places{{run.front().start(), 0.0}};
  for (const SurfaceStretch& stretch : run) {
    if (places.back().way >= max_way) break;
    add_places(stretch, max_way, places);
  }
  return places;
}

}  // namespace

std::vector<Vector3d> ramp_entry(std::span<const SurfaceStretch> run, double top_mm, double slope) {
  const double depth = top_mm - run.front().start().z() - kAboveMm;
  if (depth <= 0.0) return {};
  const double half = 0.5 * depth / slope;
  const std::vector<RampPlace> places = places_up_to(run, half);
  const double reach = places.back().way;
  if (reach < std::min(kMinLengthMm, half)) return {};
  const double turns = std::ceil(half / reach - 1.0e-9);
  const double whole = 2.0 * turns * reach;
  std::vector<Vector3d> ramp;
  const auto add = [&](const RampPlace& place, double way) {
    const double lift = kAboveMm + depth * std::max(0.0, 1.0 - way / whole);
    ramp.emplace_back(place.tip + lift * Vector3d::UnitZ());
  };
  for (double turn = 0.0; turn < turns; turn += 1.0) {
    const double done = 2.0 * turn * reach;
    for (auto place = places.begin() + 1; place != places.end(); ++place) {
      add(*place, done + place->way);
    }
    for (auto place = places.rbegin() + 1; place != places.rend(); ++place) {
      add(*place, done + 2.0 * reach - place->way);
    }
  }
  return ramp;
}

}  // namespace sim::surface
