#pragma once

#include <cstddef>

#include "planner/geometry/vector.hpp"

namespace cnc::contour {

/// A place of a curve in mm, and its first two derivatives by the share of a span.
struct CurveJet {
  WideVec2 place{0.0, 0.0};
  WideVec2 first{0.0, 0.0};
  WideVec2 second{0.0, 0.0};
};

/// Any curve of a drawing, as the fit sees it: a row of spans, each of them
/// smooth and with a share of 0…1 of its own. Between spans the place goes on,
/// the tangent and the curvature need not.
///
/// Lines and arcs need none: they are path elements already.
class PlaneCurve {
 public:
  /// At least 1.
  [[nodiscard]] virtual std::size_t span_count() const = 0;
  /// @pre span < span_count(), share in 0…1
  [[nodiscard]] virtual CurveJet at(std::size_t span, double share) const = 0;

 protected:
  ~PlaneCurve() = default;
};

}  // namespace cnc::contour
