#pragma once

#include <cstddef>

#include "planner/geometry/vector.hpp"

namespace cnc::contour {

/// A point of a curve in mm, and the point's first two derivatives with respect to the share of a
/// span.
struct CurveJet {
  WideVec2 place{0.0, 0.0};
  WideVec2 first{0.0, 0.0};
  WideVec2 second{0.0, 0.0};
};

/// Interface through which a fit evaluates any curve of a drawing. A curve is a sequence of smooth
/// spans, each with its own parameter, a share of 0…1. Between spans the curve is continuous, but
/// its tangent and its curvature may jump.
///
/// Lines and arcs do not need this interface, because they are path elements already.
class PlaneCurve {
 public:
  /// Returns the number of spans, at least 1.
  [[nodiscard]] virtual std::size_t span_count() const = 0;
  /// Returns the point at a share of a span, and its derivatives. @pre span < span_count(), share
  /// in 0…1
  [[nodiscard]] virtual CurveJet at(std::size_t span, double share) const = 0;

 protected:
  ~PlaneCurve() = default;
};

}  // namespace cnc::contour
