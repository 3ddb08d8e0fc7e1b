#include "planner/contour/bisecting_fit.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "planner/contour/arc_check.hpp"
#include "planner/contour/tolerance_band.hpp"

namespace cnc::contour {
namespace {

WideBiarcEnds ends_of(std::span<const CurveSample> polygon) {
  const WayPoint& start = polygon.front().point;
  const WayPoint& end = polygon.back().point;
  return {start.place, start.tangent, end.place, end.tangent};
}

double distance_of_polygon(const BiarcGauge& gauge,
                           std::span<const CurveSample> polygon,
                           double hopeless) {
  double greatest = 0.0;
  for (std::size_t i = 0; i + 1 < polygon.size() && greatest < hopeless; ++i) {
    const WayPoint& from = polygon[i].point;
    const WayPoint& to = polygon[i + 1].point;
    if (!gauge.beside(from.place).agrees(from.place, from.tangent)) return ToleranceBand::kNoFit;
    greatest = std::max(greatest, gauge.distance_of_edge(from.place, to.place));
  }
  return greatest;
}

/// Returns the parameter, in spans, at which the curve passes the joint of the biarc. If the curve
/// passes the joint several times, returns one of the parameters.
double spans_at_joint(const CurvePiece& piece,
                      std::span<const CurveSample> polygon,
                      const BiarcGauge& gauge) {
  constexpr int kHalves = 40;
  std::size_t i = 1;
  while (i + 1 < polygon.size() && gauge.is_first(polygon[i].point.place)) ++i;
  double low = polygon[i - 1].spans;
  double high = polygon[i].spans;
  for (int k = 0; k < kHalves; ++k) {
    const double middle = 0.5 * (low + high);
    (gauge.is_first(piece.at(middle).place) ? low : high) = middle;
  }
  return high;
}

bool stays_near(const CurvePiece& piece,
                std::span<const CurveSample> polygon,
                double share,
                double tolerance_mm) {
  constexpr double kFine = 5.0e-4;  // Precision of the check, as a share of the tolerance.
  const WideBiarcEnds ends = ends_of(polygon);
  const WideBiarc biarc = make_biarc(ends, share).value();
  const double joint = spans_at_joint(piece, polygon, BiarcGauge{ends, biarc});
  const Curve<double> first = arc_leaving(ends.start, ends.start_tangent, biarc.joint);
  const Curve<double> second = arc_leaving(biarc.joint, biarc.joint_tangent, ends.end);
  const CurveStretch before{.piece = &piece, .from = polygon.front().spans, .to = joint};
  const CurveStretch after{.piece = &piece, .from = joint, .to = polygon.back().spans};
  return arc_deviation(before, first, kFine * tolerance_mm) <= tolerance_mm &&
         arc_deviation(after, second, kFine * tolerance_mm) <= tolerance_mm;
}

}  // namespace

LeastValue optimal_biarc(std::span<const CurveSample> polygon, double enough_mm) {
  constexpr SearchRange kShares{.low = 0.05, .high = 0.95, .looks = 7, .steps = 18};
  // The evaluation of a biarc ends early at a distance of this multiple of `enough_mm`.
  constexpr double kHopeless = 50.0;
  const WideBiarcEnds ends = ends_of(polygon);
  return least_value(kShares, enough_mm, [&](double share) {
    const auto biarc = make_biarc(ends, share);
    if (!biarc.ok()) return ToleranceBand::kNoFit;
    return distance_of_polygon(BiarcGauge{ends, biarc.value()}, polygon, kHopeless * enough_mm);
  });
}

BisectingResult bisecting_fit(const CurvePiece& piece,
                              std::span<const CurveSample> polygon,
                              const BisectingLimits& limits,
                              std::span<Vertex<double>> vertices) {
  // Greatest number of stretches that wait to be fitted. Each is at most half as long as the
  // stretch that waits before it.
  constexpr std::size_t kMaxHalves = 64;
  std::array<std::size_t, kMaxHalves> ends{};
  std::size_t waiting = 0;
  ends[waiting++] = polygon.size() - 1;
  BisectingResult result{};
  std::size_t from = 0;
  while (waiting > 0) {
    const std::size_t to = ends[waiting - 1];
    const auto stretch = polygon.subspan(from, to - from + 1);
    const LeastValue best = optimal_biarc(stretch, 0.5 * limits.biarc_mm);
    if (best.value > limits.biarc_mm ||
        !stays_near(piece, stretch, best.at, 0.999 * limits.tolerance_mm)) {
      if (to - from < 2 || waiting == kMaxHalves) return {};
      ends[waiting++] = from + (to - from) / 2;
      continue;
    }
    if (result.arcs + 3 > vertices.size()) return {.out_of_room = true};
    const WideBiarcEnds whole = ends_of(stretch);
    const WideBiarc biarc = make_biarc(whole, best.at).value();
    const double first = wide_bulge_between(whole.start_tangent, biarc.joint - whole.start);
    const double second = wide_bulge_between(whole.end - biarc.joint, whole.end_tangent);
    vertices[result.arcs++] = {whole.start.x(), whole.start.y(), first};
    vertices[result.arcs++] = {biarc.joint.x(), biarc.joint.y(), second};
    vertices[result.arcs] = {whole.end.x(), whole.end.y()};
    from = to;
    --waiting;
  }
  return result;
}

}  // namespace cnc::contour
