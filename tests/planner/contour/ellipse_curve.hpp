#pragma once

#include "planner/contour/plane_curve.hpp"

namespace cnc::contour {

/// An arc of an ellipse: centre + cos t · major + sin t · minor, with t from `start` to `end` in
/// radians; clockwise if `end` is less than `start`. DXF stores its ELLIPSE in this form (minor:
/// major rotated to the left, times the ratio). SVG's elliptical arcs have this form as soon as
/// their centre is computed.
struct Ellipse {
  WideVec2 centre{0.0, 0.0};  ///< mm.
  WideVec2 major{1.0, 0.0};   ///< Vector from the centre, mm.
  WideVec2 minor{0.0, 1.0};
  double start = 0.0;
  double end = 6.28318530717958648;
};

class EllipseCurve final : public PlaneCurve {
 public:
  /// @pre start and end differ, by at most kWideSinCosRange
  explicit EllipseCurve(const Ellipse& ellipse);

  /// A span covers an eighth of a turn, or the remaining part of one.
  [[nodiscard]] std::size_t span_count() const override { return span_count_; }
  [[nodiscard]] CurveJet at(std::size_t span, double share) const override;

 private:
  Ellipse ellipse_;
  std::size_t span_count_ = 1;
};

}  // namespace cnc::contour
