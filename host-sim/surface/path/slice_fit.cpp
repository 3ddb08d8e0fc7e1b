#include "host-sim/surface/path/slice_fit.hpp"

#include <cmath>
#include <span>

#include "host-sim/surface/path/chord_fit.hpp"

namespace sim::surface {

using cnc::contour::FitEnd;
using cnc::contour::FitMethod;

namespace {

/// Change of direction between two spans, in radians, above which their joint is a corner. Corners
/// are kept.
constexpr double kMinCorner = 0.1;

cnc::WideVec2 direction_at(const cnc::contour::PlaneCurve& curve, std::size_t span, double share) {
  return curve.at(span, share).first.normalized();
}

bool has_corner_before(const cnc::contour::PlaneCurve& curve, std::size_t span) {
  const cnc::WideVec2 before = direction_at(curve, span - 1, 1.0);
  const cnc::WideVec2 after = direction_at(curve, span, 0.0);
  return before.dot(after) < std::cos(kMinCorner);
}

}  // namespace

std::size_t SliceFitter::fit(const cnc::contour::PlaneCurve& curve,
                             double tolerance_mm,
                             SliceElements elements,
                             std::vector<ContourVertex>& out) {
  std::size_t without_arcs = 0;
  std::size_t from = 0;
  for (std::size_t to = 1; to <= curve.span_count(); ++to) {
    if (to < curve.span_count() && !has_corner_before(curve, to)) continue;
    // Removes the end of the previous piece, because it is also the start of this piece.
    if (from > 0) out.pop_back();
    const bool wants_arcs = elements == SliceElements::kArcs;
    if (!wants_arcs || !fit_arcs_to(curve, {from, to}, tolerance_mm, out)) {
      fit_chords(curve, {from, to}, tolerance_mm, out);
      if (wants_arcs) ++without_arcs;
    }
    from = to;
  }
  return without_arcs;
}

bool SliceFitter::fit_arcs_to(const cnc::contour::PlaneCurve& curve,
                              const SpanRange& spans,
                              double tolerance_mm,
                              std::vector<ContourVertex>& out) {
  constexpr std::size_t kMinRoom = 4'096;
  constexpr std::size_t kRoomOfSpan = 256;
  const cnc::contour::CurvePiece piece{.curve = &curve,
                                       .from = static_cast<double>(spans.from),
                                       .to = static_cast<double>(spans.to)};
  const cnc::contour::FitOptions options{.tolerance_mm = tolerance_mm,
                                         .method = FitMethod::kFewest,
                                         .start = FitEnd::kPlace,
                                         .end = FitEnd::kPlace};
  const std::size_t size = kMinRoom + kRoomOfSpan * (spans.to - spans.from);
  if (samples_.size() < size) {
    samples_.resize(size);
    links_.resize(size / 8);
    fitted_.resize(size / 4);
  }
  const auto made = cnc::contour::fit_arcs(piece, options, {samples_, links_}, fitted_);
  if (!made.ok()) return false;
  const auto arcs = std::span{fitted_}.first(made.value() + 1);
  out.insert(out.end(), arcs.begin(), arcs.end());
  return true;
}

}  // namespace sim::surface
