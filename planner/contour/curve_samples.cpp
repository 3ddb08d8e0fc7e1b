#include "planner/contour/curve_samples.hpp"

#include <algorithm>
#include <cmath>

namespace cnc::contour {
namespace {

/// Greatest turn between two samples, radians.
constexpr double kMaxTurn = 0.2;

/// Chord length and turn between two samples.
struct SampleStep {
  double chord = 0.0;
  double turn = 0.0;  ///< Angle in radians, positive to the left.
};

SampleStep step_between(const WayPoint& from, const WayPoint& to) {
  const double sine = cross(from.tangent, to.tangent);
  const double cosine = from.tangent.dot(to.tangent);
  constexpr double kTooMuch = 1.0e3;
  // If the turn is within kMaxTurn, this series of the sine is close enough to the angle.
  return {.chord = (to.place - from.place).norm(),
          .turn = cosine > 0.0 ? sine * (1.0 + sine * sine / 6.0) : kTooMuch};
}

/// Returns whether the curve is near enough to its chord and to an arc. If the curvature grows by Δ
/// over a chord c, the curve differs from an arc by about Δ c² / 64 on either side of the middle.
/// If one arc covers several samples, the curve differs from it by less than that between them.
bool near_enough(const SampleStep& step, const SampleStep& before, const SampleDensity& density) {
  const double size = std::abs(step.turn);
  if (size > kMaxTurn) return false;
  if (step.chord * size > 8.0 * density.sagitta_mm) return false;
  if (before.chord <= 0.0 || step.chord <= 0.0) return true;
  const double change = std::abs(step.turn / step.chord - before.turn / before.chord);
  return change * step.chord * step.chord <= density.bend_mm;
}

/// Returns whether the point `middle` is close to the chord. Near a cusp the turn between both ends
/// does not show how far the curve is from its chord.
bool is_beside_chord(const WayPoint& from,
                     const WayPoint& middle,
                     const WayPoint& to,
                     double sagitta_mm) {
  const WideVec2 chord = to.place - from.place;
  const WideVec2 seen = middle.place - from.place;
  const double square = chord.squaredNorm();
  const double along = seen.dot(chord);
  if (!(along >= 0.0 && along <= square)) return false;
  return std::abs(cross(chord, seen)) <= 0.9 * sagitta_mm * std::sqrt(square);
}

}  // namespace

std::size_t sample_curve(const CurvePiece& piece,
                         const SampleDensity& density,
                         std::span<CurveSample> room) {
  // Largest step in spans. A detail of the curve that is wider than this step is found.
  constexpr double kLargestStep = 1.0 / 8.0;
  constexpr double kMinStep = 1.0e-14;
  constexpr double kGrowth = 1.4;
  if (room.empty()) return 0;
  const double length = piece.to - piece.from;
  room[0] = {.point = piece.at(piece.from), .spans = piece.from};
  std::size_t count = 1;
  double stride = kLargestStep / 16.0;
  SampleStep before{};
  while (room[count - 1].spans < piece.to) {
    if (count == room.size()) return 0;
    const CurveSample& last = room[count - 1];
    const double rest = piece.to - last.spans;
    const double least = kMinStep * std::max(length, piece.to);
    // These lines avoid a tiny step at the end of the piece.
    stride = std::clamp(stride, std::min(least, rest), kLargestStep);
    const bool ends = rest <= 1.01 * stride;
    if (!ends && rest < 2.0 * stride) stride = 0.5 * rest;
    const double spans = ends ? piece.to : last.spans + stride;
    const WayPoint point = piece.at(spans);
    const SampleStep step = step_between(last.point, point);
    const WayPoint middle = piece.at(0.5 * (last.spans + spans));
    const bool near = near_enough(step, before, density) &&
                      is_beside_chord(last.point, middle, point, density.sagitta_mm);
    if (stride > least && !near) {
      stride *= 0.6;
      continue;
    }
    if (!near && (step.chord > density.sagitta_mm || std::abs(step.turn) > kMaxTurn)) return 1;
    room[count] = {.point = point, .spans = spans, .turned = last.turned + std::abs(step.turn)};
    ++count;
    before = step;
    stride *= kGrowth;
  }
  return count;
}

}  // namespace cnc::contour
