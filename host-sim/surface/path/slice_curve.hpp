#pragma once

#include <cstddef>
#include <vector>

#include "host-sim/surface/path/slice_heights.hpp"
#include "planner/contour/plane_curve.hpp"

namespace sim::surface {

/// Limits for the deviation of a curve from the heights of a slice.
struct SliceDensity {
  double pitch_mm = 0.1;  ///< Maximum distance between sampled heights.
  /// Maximum error of the curve between samples, perpendicular to the curve.
  double error_mm = 1.0e-3;
  /// Length up to which spans are straight, because the heights jump there.
  double min_mm = 1.0e-4;
};

/// Returns the density at which nothing between two samples reaches into the tool by more than
/// `error_mm`. Between two samples, a round tool deviates from its chord by the sagitta, and a cone
/// deviates by the height of its sides.
[[nodiscard]] SliceDensity density_for(const cnc::surface::Profile& profile, double error_mm);

/// Spans of a curve from `from` up to but not including `to`.
struct SpanRange {
  std::size_t from = 0;
  std::size_t to = 0;
};

/// The heights of a slice as a smooth curve. The curve consists of cubics over the distance along
/// the slice. The ends of the cubics have the heights and slopes of the slice. The first coordinate
/// of the curve is the distance along the slice; the second is the height.
class SliceCurve final : public cnc::contour::PlaneCurve {
 public:
  struct Node {
    double along = 0.0;
    double height = 0.0;
    double slope = 0.0;  ///< Slope of the heights along the slice, mm per mm.
  };

  /// @pre begin < end, and all points from `begin` to `end` have a height
  SliceCurve(SliceHeights& heights, double begin, double end, const SliceDensity& density);

  [[nodiscard]] std::size_t span_count() const override { return nodes_.size() - 1; }
  [[nodiscard]] SpanRange all() const { return {0, span_count()}; }
  [[nodiscard]] cnc::contour::CurveJet at(std::size_t span, double share) const override;

  [[nodiscard]] const std::vector<Node>& nodes() const { return nodes_; }

 private:
  [[nodiscard]] bool is_straight(std::size_t span) const;

  std::vector<Node> nodes_;
  double error_mm_;
  double min_mm_;
};

}  // namespace sim::surface
