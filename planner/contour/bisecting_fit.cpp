#include "planner/contour/bisecting_fit.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "planner/contour/tolerance_band.hpp"

namespace cnc {
namespace {

BiarcEndsD ends_of(std::span<const CurveSample> polygon) {
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

bool stays_near(const CurvePiece& piece,
                std::span<const CurveSample> polygon,
                double share,
                double tolerance_mm) {
  constexpr int kLooks = 6;
  constexpr double kHalfTurn = 3.14159265358979324;
  constexpr double kMoreTurn = 1.0;  // Radians; beyond, an arc goes round the long way.
  const BiarcEndsD ends = ends_of(polygon);
  const BiarcD biarc = make_biarc(ends, share).value();
  const double turned = polygon.back().turned - polygon.front().turned;
  // An arc of at most half a turn turns by at least π times its bulge.
  if (kHalfTurn * (std::abs(biarc.first_bulge) + std::abs(biarc.second_bulge)) >
      turned + kMoreTurn) {
    return false;
  }
  const BiarcGauge gauge{ends, biarc};
  for (std::size_t i = 0; i + 1 < polygon.size(); ++i) {
    const double stride = (polygon[i + 1].spans - polygon[i].spans) / kLooks;
    for (int k = 0; k <= kLooks; ++k) {
      const WayPoint point = piece.at(polygon[i].spans + static_cast<double>(k) * stride);
      if (!(ToleranceBand::distance(gauge.beside(point.place), point) <= tolerance_mm))
        return false;
    }
  }
  return true;
}

}  // namespace

LeastValue optimal_biarc(std::span<const CurveSample> polygon, double enough_mm) {
  constexpr SearchRange kShares{.low = 0.05, .high = 0.95, .looks = 7, .steps = 18};
  constexpr double kHopeless = 50.0;  // Times what is enough.
  const BiarcEndsD ends = ends_of(polygon);
  return least_value(kShares, enough_mm, [&](double share) {
    const auto biarc = make_biarc(ends, share);
    if (!biarc.ok()) return ToleranceBand::kNoFit;
    return distance_of_polygon(BiarcGauge{ends, biarc.value()}, polygon, kHopeless * enough_mm);
  });
}

BisectingResult bisecting_fit(const CurvePiece& piece,
                              std::span<const CurveSample> polygon,
                              const BisectingLimits& limits,
                              std::span<ChainArc> arcs) {
  // Halves that wait: each is at most half as long as the one below it.
  constexpr std::size_t kMostHalves = 64;
  std::array<std::size_t, kMostHalves> ends{};
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
      if (to - from < 2 || waiting == kMostHalves) return {};
      ends[waiting++] = from + (to - from) / 2;
      continue;
    }
    if (result.arcs + 2 > arcs.size()) return {.out_of_room = true};
    const BiarcEndsD whole = ends_of(stretch);
    const BiarcD biarc = make_biarc(whole, best.at).value();
    arcs[result.arcs++] = {whole.start,
                           biarc.joint,
                           bulge_between(whole.start_tangent, Vec2D{biarc.joint - whole.start})};
    arcs[result.arcs++] = {
        biarc.joint, whole.end, bulge_between(Vec2D{whole.end - biarc.joint}, whole.end_tangent)};
    from = to;
    --waiting;
  }
  return result;
}

}  // namespace cnc
