#pragma once

#include <cstdint>
#include <vector>

#include "host-sim/contour/contour_offset.hpp"
#include "host-sim/surface/path/slice_curve.hpp"
#include "planner/contour/arc_spline_fit.hpp"

namespace sim::surface {

enum class SliceElements : std::uint8_t {
  kArcs,   ///< Tangent-continuous arcs and lines.
  kLines,  ///< Lines only, for example if the slice is not in a plane that allows arcs.
};

/// Replaces the curves of slices by few arcs or lines, within a tolerance of the curve and from its
/// start to its end. Corners keep their positions. The object contains working memory that
/// successive fits share.
class SliceFitter {
 public:
  /// Appends the elements for a curve to `out`. A vertex consists of the distance along the slice
  /// and the height, and the bulge of an arc.
  /// @param tolerance_mm tolerance, above 0
  /// @return the number of pieces between corners that became lines because no arcs are within the
  /// tolerance
  std::size_t fit(const cnc::contour::PlaneCurve& curve,
                  double tolerance_mm,
                  SliceElements elements,
                  std::vector<ContourVertex>& out);

 private:
  [[nodiscard]] bool fit_arcs_to(const cnc::contour::PlaneCurve& curve,
                                 const SpanRange& spans,
                                 double tolerance_mm,
                                 std::vector<ContourVertex>& out);

  std::vector<cnc::contour::CurveSample> samples_;
  std::vector<cnc::contour::FitLink> links_;
  std::vector<ContourVertex> fitted_;
};

}  // namespace sim::surface
