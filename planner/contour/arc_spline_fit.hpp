#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "planner/base/result.hpp"
#include "planner/contour/contour.hpp"
#include "planner/contour/curve_piece.hpp"
#include "planner/contour/curve_samples.hpp"
#include "planner/contour/tolerance_band.hpp"

namespace cnc::contour {

enum class FitMethod : std::uint8_t {
  /// Joints and tangents are free within the tolerance. The fit finds as few arcs as it can.
  kFewest,
  /// Method of paper 1: joints are on the curve, and a stretch is halved until a biarc fits it.
  kBisecting,
};

/// Property that an arc spline keeps exactly at an end of the curve. kBisecting always keeps point
/// and tangent.
enum class FitEnd : std::uint8_t {
  /// Keeps the point and the tangent, so that a neighbour that joins smoothly still joins smoothly.
  kTangent,
  kPlace,  ///< Keeps only the point, for a corner.
  /// Keeps neither the point nor the tangent. The end may be anywhere within the tolerance on the
  /// curve's normal.
  kFree,
};

struct FitOptions {
  double tolerance_mm = 0.01;
  FitMethod method = FitMethod::kFewest;
  FitEnd start = FitEnd::kTangent;
  FitEnd end = FitEnd::kTangent;
  /// For kBisecting: share of the tolerance by which the base polygon may deviate from the curve (a
  /// in paper 1), at most a half.
  double polygon_share = 0.2;
};

enum class FitError : std::uint8_t {
  kTooManySamples,  ///< The curve requires more samples than `FitRoom::samples` can hold.
  kTooManyArcs,
  /// The curve jumps, or it turns at one point too sharply for the resolution of its parameter.
  kNoFit,
};

/// An arc of a chain during its construction. It extends from `start` to the `start` of the next
/// link.
struct FitLink {
  BandStart start{};
  double curvature = 0.0;
  /// Position along the curve, in samples, up to which the arc could stay within the band.
  double reach = 0.0;

  [[nodiscard]] WideTangentCircle circle() const { return start.circle(curvature); }
};

/// Working storage of a fit. About 60 samples for each arc are enough. `links` needs two entries
/// more than there are arcs.
struct FitRoom {
  std::span<CurveSample> samples;
  std::span<FitLink> links;
};

/// Replaces a smooth piece of a curve, or of its offset, by arcs.
///
/// Guarantees, as long as the tolerance is at least 1e-9 of the greatest coordinate:
/// * No point of the chain is farther than the tolerance from the piece, and no point of the piece
///   is farther than the tolerance from the chain: arc_deviation() confirms each arc.
/// * Elements join exactly, and their tangents agree within kFitKink radians. The tangents are
///   computed from ends and bulges, for elements longer than 1e-4 mm.
/// * The ends are kept as `options` requires, tangents within kFitKink.
///
/// To offset a chain of curves with corners (paper 1, 4.2), call split_offset() for each curve and
/// fit_arcs() for each piece; lines and arcs are offset directly. Use kTangent where the chain
/// continues smoothly, and kPlace at corners and cusps. At a corner, neighbours are joined by an
/// arc around the corner or at their crossing. The result is the raw offset with all its loops.
/// offset() continues from there as it does for arc splines.
///
/// The storage bounds the work: number of samples times kMaxTries times a few hundred.
/// @param vertices storage for one vertex more than there are arcs: for each arc its start with its
///     bulge, at most half a turn, then the end.
/// @return the number of arcs.
[[nodiscard]] Result<std::size_t, FitError> fit_arcs(const CurvePiece& piece,
                                                     const FitOptions& options,
                                                     const FitRoom& room,
                                                     std::span<Vertex<double>> vertices);
inline constexpr double kFitKink = 1.0e-8;

}  // namespace cnc::contour
