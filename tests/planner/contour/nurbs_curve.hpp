#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "planner/base/result.hpp"
#include "planner/contour/plane_curve.hpp"

namespace cnc::contour {

/// A control point with its weight, which attracts the curve.
struct WeightedPlace {
  WideVec2 place{0.0, 0.0};  ///< mm.
  double weight = 1.0;
};

enum class NurbsError : std::uint8_t {
  kDegree,        ///< The degree is not in 1…kHighestDegree.
  kTooFewPoints,  ///< There are fewer points than the order.
  kKnotCount,     ///< The number of knots is not points + order.
  kKnotOrder,     ///< A knot is less than the one before it, or not a number.
  kKnotRepeated,  ///< A knot is repeated so often that the curve has a gap.
  kWeight,        ///< A weight is not greater than 0.
  kTooManySpans,  ///< There are more than kMaxSpans spans.
  kNotAPlace,     ///< A coordinate of a control point is not a number.
};

/// A rational B-spline over any knots. Special cases are a quadratic or cubic Bézier curve (knots 0
/// … 0, 1 … 1), a B-spline (equal weights), and a circle as CAD systems store it (degree 2).
///
/// The caller owns control points and knots, which must outlive this object.
///
/// Guarantee: the error of the point is at most kNurbsError times the greatest coordinate. The
/// derivatives are those of the same curve (de Boor in homogeneous coordinates).
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
  std::array<std::uint16_t, kMaxSpans> spans_{};  ///< Knot at which each span begins.
};

inline constexpr double kNurbsError = 1.0e-13;

}  // namespace cnc::contour
