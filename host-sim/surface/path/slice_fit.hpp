#pragma once

#include <cstdint>
#include <vector>

#include "host-sim/contour/contour_offset.hpp"
#include "host-sim/surface/path/slice_curve.hpp"
#include "planner/contour/arc_spline_fit.hpp"

namespace sim::surface {

enum class SliceElements : std::uint8_t {
  kArcs,   ///< Arcs and lines with one tangent.
  kLines,  ///< Lines only, as where no plane of arcs holds the slice.
};

/// Replaces the curves of slices by few arcs or lines, each within a tolerance of its curve, from
/// the curve's start to its end. Corners stay where they are. Holds the room that fits work with.
class SliceFitter {
 public:
  /// Appends the elements: places by the way along the slice and the height, arcs by their bulge.
  /// @param tolerance_mm above 0
  /// @return how many pieces between corners had no arcs within the tolerance and became lines.
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
