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
  kFewest,     ///< Joints and tangents free within the tolerance: as few arcs as it finds.
  kBisecting,  ///< Of paper 1: joints on the curve, halved until a biarc fits.
};

/// What an arc spline keeps of the curve's end exactly. kBisecting keeps both.
enum class FitEnd : std::uint8_t {
  kTangent,  ///< The place and the tangent: whatever joins there smoothly still does.
  kPlace,    ///< The place alone: at a corner.
  kFree,     ///< Neither: anywhere within the tolerance on the curve's normal.
};

struct FitOptions {
  double tolerance_mm = 0.01;
  FitMethod method = FitMethod::kFewest;
  FitEnd start = FitEnd::kTangent;
  FitEnd end = FitEnd::kTangent;
  /// Of kBisecting: the share of the tolerance that the base polygon takes, a in the
  /// paper, at most a half.
  double polygon_share = 0.2;
};

enum class FitError : std::uint8_t {
  kTooManySamples,  ///< More than there is room for.
  kTooManyArcs,
  kNoFit,  ///< The curve jumps, or turns on the spot more sharply than its digits tell.
};

/// An arc of a chain in the making: from `start` until the next one's.
struct FitLink {
  BandStart start{};
  double curvature = 0.0;
  double reach = 0.0;  ///< How far it could go, in samples.

  [[nodiscard]] WideTangentCircle circle() const { return start.circle(curvature); }
};

/// What a fit works with. Some 60 samples for each arc are enough, and two links more than arcs.
struct FitRoom {
  std::span<CurveSample> samples;
  std::span<FitLink> links;
};

/// Replaces a smooth piece of a curve, or of its offset, by arcs.
///
/// Guarantees, as long as the tolerance is at least 1e-9 of the greatest coordinate:
/// * No place of the chain is farther than the tolerance from the piece, and none of
///   the piece farther than that from the chain: arc_deviation() confirms each arc.
/// * Elements join exactly, and with one tangent within kFitKink radians, computed from
///   their ends and bulges, where they are longer than 1e-4 mm.
/// * Ends are met as `options` asks, tangents within kFitKink.
///
/// How a chain of curves with corners is offset (paper 1, 4.2): split_offset() each
/// curve; lines and arcs shift by themselves; each piece becomes arcs, with kTangent where the
/// chain goes on smoothly and kPlace at corners and cusps; at corners an arc around the corner or
/// the crossing joins what the neighbours leave. That is the raw offset, loops
/// and all, which the offset of arc splines takes from there.
///
/// Work is bounded by the room: samples times kMostTries times a few hundred.
/// @param vertices room for one more than there are arcs: where each begins with its bulge, at most
/// half a turn, then the end. @return how many arcs.
[[nodiscard]] Result<std::size_t, FitError> fit_arcs(const CurvePiece& piece,
                                                     const FitOptions& options,
                                                     const FitRoom& room,
                                                     std::span<Vertex<double>> vertices);
inline constexpr double kFitKink = 1.0e-8;

}  // namespace cnc::contour
