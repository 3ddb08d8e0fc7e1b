#include "host-sim/pocket/driven_loop.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "planner/pocket/loop_measures.hpp"

namespace sim::pocket {
namespace {

std::vector<cut::Stroke> strokes_of(const cnc::contour::ContourView<double>& contour,
                                    std::size_t loop,
                                    cnc::pocket::Milling milling) {
  std::vector<cut::Stroke> strokes;
  for (std::uint32_t i = contour.loop_begin(loop); i < contour.loop_ends[loop]; ++i) {
    const auto element = cnc::pocket::element_at(contour, loop, i);
    if (element.start == element.end) continue;
    const cut::Stroke stroke{.from = element.start, .to = element.end, .bulge = element.bulge};
    if (std::abs(stroke.bulge) <= 1.0) {
      strokes.push_back(stroke);
    } else {
      strokes.push_back(cut::part_of(stroke, 0.0, 0.5));
      strokes.push_back(cut::part_of(stroke, 0.5, 1.0));
    }
  }
  return milling == cnc::pocket::Milling::kClimb ? strokes : reversed(std::move(strokes));
}

/// Returns the share of a stroke's length up to the point nearest to `place`.
double share_at(const cut::Stroke& stroke, const cnc::WideVec2& place) {
  cnc::contour::Curve<double> curve;
  if (!cnc::pocket::make_curve<double>({stroke.from, stroke.to, stroke.bulge}, curve)) return 0.0;
  if (!curve.faces(place, 0.0)) {
    return (place - curve.start).squaredNorm() < (place - curve.end).squaredNorm() ? 0.0 : 1.0;
  }
  if (curve.curvature == 0.0) {
    return std::clamp(
        curve.start_tangent.dot(place - curve.start) / cut::length_of(stroke), 0.0, 1.0);
  }
  // If `place` is the start within rounding, the direction of the chord to it is arbitrary.
  constexpr double kAtStartMm = 1.0e-9;
  if ((place - curve.start).norm() <= kAtStartMm) return 0.0;
  const double part = std::atan(curve.bulge_between(curve.start, place));
  return std::clamp(part / std::atan(stroke.bulge), 0.0, 1.0);
}

}  // namespace

std::vector<cut::Stroke> reversed(std::vector<cut::Stroke> row) {
  std::ranges::reverse(row);
  for (cut::Stroke& stroke : row) {
    std::swap(stroke.from, stroke.to);
    stroke.bulge = -stroke.bulge;
  }
  return row;
}

DrivenLoop::DrivenLoop(const cnc::contour::ContourView<double>& contour,
                       std::size_t loop,
                       cnc::pocket::Milling milling)
    : row_{strokes_of(contour, loop, milling)} {}

double DrivenLoop::way_at(const cnc::WideVec2& place) const {
  double least = std::numeric_limits<double>::infinity();
  std::size_t nearest = 0;
  for (std::size_t i = 0; i < row_.strokes().size(); ++i) {
    const double away = cut::distance_to(row_.strokes()[i], place);
    if (away >= least) continue;
    least = away;
    nearest = i;
  }
  const cut::Stroke& stroke = row_.strokes()[nearest];
  return row_.way_to(nearest) + share_at(stroke, place) * cut::length_of(stroke);
}

std::vector<cut::Stroke> DrivenLoop::stretch(double from_mm, double to_mm) const {
  if (from_mm < to_mm) return row_.stretch(from_mm, to_mm);
  std::vector<cut::Stroke> strokes = row_.stretch(from_mm, row_.length());
  const std::vector<cut::Stroke> rest = row_.stretch(0.0, to_mm);
  strokes.insert(strokes.end(), rest.begin(), rest.end());
  return strokes;
}

double DrivenLoop::longest_middle() const {
  std::size_t longest = 0;
  for (std::size_t i = 1; i < row_.strokes().size(); ++i) {
    if (cut::length_of(row_.strokes()[i]) > cut::length_of(row_.strokes()[longest])) longest = i;
  }
  return 0.5 * (row_.way_to(longest) + row_.way_to(longest + 1));
}

}  // namespace sim::pocket
