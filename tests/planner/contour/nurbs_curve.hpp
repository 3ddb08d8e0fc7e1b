#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "planner/base/result.hpp"
#include "planner/contour/plane_curve.hpp"

namespace cnc::contour {

/// What draws a curve towards it.
struct WeightedPlace {
  WideVec2 place{0.0, 0.0};  ///< mm.
  double weight = 1.0;
};

enum class NurbsError : std::uint8_t {
  kDegree,        ///< Not 1…kHighestDegree.
  kTooFewPoints,  ///< Fewer than the order.
  kKnotCount,     ///< Not points + order.
  kKnotOrder,     ///< A knot below the one before it, or none a number.
  kKnotRepeated,  ///< So often that the curve falls apart there.
  kWeight,        ///< Not above 0.
  kTooManySpans,  ///< More than kMaxSpans.
  kNotAPlace,     ///< A control point that is no number.
};

/// A rational B-spline over any knots. A Bézier curve, quadratic or cubic, is one
/// over the knots 0 … 0, 1 … 1; a B-spline one with all weights equal; a circle
/// as CAD systems write it one of degree 2.
///
/// Control points and knots stay the caller's and must outlive it.
///
/// Guarantee: the place is within kNurbsError of the greatest coordinate, the
/// derivatives those of the very curve (de Boor in homogeneous coordinates).
class NurbsCurve final : public PlaneCurve {
 public:
  static constexpr std::size_t kHighestDegree = 11;
  static constexpr std::size_t kMaxSpans = 512;

  [[nodiscard]] static Result<NurbsCurve, NurbsError> make(std::size_t degree,
                                                           std::span<const WeightedPlace> points,
                                                           std::span<const double> knots);

  [[nodiscard]] std::size_t span_count() const override { return span_count_; }
  [[nodiscard]] CurveJet at(std::size_t span, double share) const override;

 private:
  NurbsCurve(std::size_t degree,
             std::span<const WeightedPlace> points,
             std::span<const double> knots)
      : points_{points}, knots_{knots}, degree_{degree} {}

  std::span<const WeightedPlace> points_;
  std::span<const double> knots_;
  std::size_t degree_;
  std::size_t span_count_ = 0;
  std::array<std::uint16_t, kMaxSpans> spans_{};  ///< The knot at which each begins.
};

inline constexpr double kNurbsError = 1.0e-13;

}  // namespace cnc::contour
