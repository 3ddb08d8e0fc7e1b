#include "planner/contour/arc_spline_fit.hpp"

#include <algorithm>
#include <cmath>

#include "planner/base/contract.hpp"
#include "planner/contour/arc_check.hpp"
#include "planner/contour/bisecting_fit.hpp"
#include "planner/contour/fewest_arcs.hpp"
#include "planner/geometry/biarc.hpp"

namespace cnc::contour {
namespace {

/// Share of the tolerance that is reserved for deviations between samples.
constexpr double kUnseenShare = 3.0e-3;
/// Share of the tolerance that the measured deviation of a chain may use. The rest is reserved for
/// a rise of the distance between two samples that neither sample shows.
constexpr double kConfirmedShare = 0.999;
/// Precision of the check of a chain, as a share of the tolerance.
constexpr double kFineShare = 5.0e-4;
constexpr int kMaxTries = 14;
constexpr int kMaxPolygons = 4;

constexpr double kMinChord = 1.0e-9;

bool within_half_a_turn(const WideVec2& chord, const WideVec2& tangent) {
  constexpr double kMinCosine = 1.0e-3;  // Least cosine of half the sweep of an arc.
  return chord.dot(tangent) >= kMinCosine * chord.norm();
}

WideVec2 end_of_chain(const ToleranceBand& band, FitEnd end, const FitLink& last) {
  if (end != FitEnd::kFree) return band.point_at(band.last()).place;
  return band.start_on(last.circle(), band.last()).place;
}

/// Returns the greatest distance between the chain and the piece, measured in both directions.
double deviation_of_chain(const CurvePiece& piece,
                          const ToleranceBand& band,
                          const FitOptions& options,
                          std::span<const FitLink> links) {
  const double fine_mm = kFineShare * options.tolerance_mm;
  double greatest = 0.0;
  for (std::size_t i = 0; i < links.size(); ++i) {
    const bool last = i + 1 == links.size();
    const WideVec2 end =
        last ? end_of_chain(band, options.end, links[i]) : links[i + 1].start.place;
    const CurveStretch beside{.piece = &piece,
                              .from = band.spans_at(links[i].start.sample),
                              .to = band.spans_at(last ? band.last() : links[i + 1].start.sample)};
    const Curve<double> arc = arc_leaving(links[i].start.place, links[i].start.tangent, end);
    greatest = std::max(greatest, arc_deviation(beside, arc, fine_mm));
  }
  return greatest;
}

/// Writes the links of a chain as arcs. Each bulge is computed from the tangent at the end of the
/// previous arc, so that rounding of the joints makes no corners.
class ChainWriter {
 public:
  ChainWriter(const FitLink& first, std::span<Vertex<double>> vertices)
      : here_{first.start.place}, tangent_{first.start.tangent}, vertices_{vertices} {}

  [[nodiscard]] bool go_to(const WideVec2& place, double curvature) {
    const WideVec2 chord = place - here_;
    if (chord.norm() < kMinChord) return true;
    if (count_ > 0 && continues(place, curvature)) {
      leave_for(place, tangent_before_, before_);
      return true;
    }
    if (count_ + 1 >= vertices_.size()) return false;
    ++count_;
    before_ = here_;
    tangent_before_ = tangent_;
    curvature_ = curvature;
    leave_for(place, tangent_before_, before_);
    return true;
  }
  [[nodiscard]] std::size_t count() const { return count_; }

 private:
  /// Returns whether the arc to `place` continues the circle of the last arc, and both arcs
  /// together are at most half of that circle.
  [[nodiscard]] bool continues(const WideVec2& place, double curvature) const {
    // Greatest turn, radians, by which two arcs of one circle may differ because of rounding.
    constexpr double kSameTurn = 1.0e-10;
    const WideVec2 whole = place - before_;
    const double length = (here_ - before_).norm() + (place - here_).norm();
    return std::abs(curvature - curvature_) * length < kSameTurn &&
           within_half_a_turn(whole, tangent_before_);
  }

  /// Writes the last arc, which begins at `start` along `tangent` and ends at `place`.
  void leave_for(const WideVec2& place, const WideVec2& tangent, const WideVec2& start) {
    const WideVec2 chord = place - start;
    vertices_[count_ - 1] = {start.x(), start.y(), wide_bulge_between(tangent, chord)};
    vertices_[count_] = {place.x(), place.y()};
    tangent_ = (2.0 * tangent.dot(chord) / chord.squaredNorm() * chord - tangent).normalized();
    here_ = place;
  }

  WideVec2 here_;
  WideVec2 tangent_;
  WideVec2 before_{0.0, 0.0};
  WideVec2 tangent_before_{1.0, 0.0};
  double curvature_ = 0.0;
  std::span<Vertex<double>> vertices_;
  std::size_t count_ = 0;
};

Result<std::size_t, FitError> write_chain(const ToleranceBand& band,
                                          FitEnd end,
                                          std::span<const FitLink> links,
                                          std::span<Vertex<double>> vertices) {
  ChainWriter writer{links.front(), vertices};
  for (std::size_t i = 0; i + 1 < links.size(); ++i) {
    if (!writer.go_to(links[i + 1].start.place, links[i].curvature)) return FitError::kTooManyArcs;
  }
  const FitLink& last = links.back();
  const WideVec2 place = end_of_chain(band, end, last);
  if (!writer.go_to(place, last.curvature)) return FitError::kTooManyArcs;
  if (writer.count() == 0) return FitError::kNoFit;
  return writer.count();
}

Result<std::size_t, FitError> fit_fewest(const CurvePiece& piece,
                                         const FitOptions& options,
                                         const FitRoom& room,
                                         std::span<Vertex<double>> vertices) {
  double inner = (1.0 - kUnseenShare) * options.tolerance_mm;
  for (int i = 0; i < kMaxTries; ++i) {
    const SampleDensity density{.sagitta_mm = 0.25 * inner, .bend_mm = 0.003 * inner};
    const std::size_t count = sample_curve(piece, density, room.samples);
    if (count == 0) return FitError::kTooManySamples;
    if (count == 1) return FitError::kNoFit;
    const ToleranceBand band{piece, room.samples.first(count), inner};
    FewestArcs fewest{band, options, room.links};
    const std::size_t made = fewest.run();
    if (fewest.out_of_room()) return FitError::kTooManyArcs;
    const auto links = room.links.first(made);
    const double found =
        made > 0 ? deviation_of_chain(piece, band, options, links) : ToleranceBand::kNoFit;
    if (found <= kConfirmedShare * options.tolerance_mm) {
      return write_chain(band, options.end, links, vertices);
    }
    inner *= std::clamp(kConfirmedShare * options.tolerance_mm / found, 0.5, 0.999);
  }
  return FitError::kNoFit;
}

/// Fits arcs by the method of paper 1. If no biarc fits even one edge of the polygon, the polygon
/// is too coarse for its tangents. The function then tries a finer polygon.
Result<std::size_t, FitError> fit_bisecting(const CurvePiece& piece,
                                            const FitOptions& options,
                                            const FitRoom& room,
                                            std::span<Vertex<double>> vertices) {
  double sagitta = options.polygon_share * options.tolerance_mm;
  const BisectingLimits limits{.biarc_mm = kConfirmedShare * options.tolerance_mm - sagitta,
                               .tolerance_mm = options.tolerance_mm};
  for (int i = 0; i < kMaxPolygons; ++i) {
    const SampleDensity density{.sagitta_mm = 0.9 * sagitta, .bend_mm = 0.5 * sagitta};
    const std::size_t count = sample_curve(piece, density, room.samples);
    if (count == 0) return i == 0 ? FitError::kTooManySamples : FitError::kNoFit;
    if (count == 1) return FitError::kNoFit;
    const BisectingResult result =
        bisecting_fit(piece, room.samples.first(count), limits, vertices);
    if (result.out_of_room) return FitError::kTooManyArcs;
    if (result.arcs > 0) return result.arcs;
    sagitta *= 0.25;
  }
  return FitError::kNoFit;
}

}  // namespace

Result<std::size_t, FitError> fit_arcs(const CurvePiece& piece,
                                       const FitOptions& options,
                                       const FitRoom& room,
                                       std::span<Vertex<double>> vertices) {
  CNC_ASSERT(piece.curve != nullptr && piece.to > piece.from && options.tolerance_mm > 0.0);
  CNC_ASSERT(options.polygon_share > 0.0 && options.polygon_share <= 0.5);
  if (options.method == FitMethod::kBisecting) return fit_bisecting(piece, options, room, vertices);
  const auto fewest = fit_fewest(piece, options, room, vertices);
  if (fewest.ok() || fewest.error() != FitError::kNoFit) return fewest;
  return fit_bisecting(piece, options, room, vertices);
}

}  // namespace cnc::contour
