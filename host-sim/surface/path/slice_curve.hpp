#pragma once

#include <cstddef>
#include <vector>

#include "host-sim/surface/path/slice_heights.hpp"
#include "planner/contour/plane_curve.hpp"

namespace sim::surface {

/// How closely a curve follows the heights that it is made of.
struct SliceDensity {
  double pitch_mm = 0.1;     ///< Distance of the places at which heights are looked at, at most.
  double error_mm = 1.0e-3;  ///< Of the curve beside those places, across it.
  double least_mm = 1.0e-4;  ///< Spans of this length are straight: heights jump there.
};

/// Returns the density at which nothing between two places reaches into the tool by more than
/// `error_mm`: a round tool leaves its chord by the sagitta, a cone by the height of its sides.
[[nodiscard]] SliceDensity density_for(const cnc::surface::Profile& profile, double error_mm);

/// Spans of a curve, from one up to another that is not of them.
struct SpanRange {
  std::size_t from = 0;
  std::size_t to = 0;
};

/// The heights of a slice as a smooth curve: cubics of the way, whose ends have the heights and
/// the slopes there. The curve's first coordinate is the way along the slice.
class SliceCurve final : public cnc::contour::PlaneCurve {
 public:
  struct Node {
    double along = 0.0;
    double height = 0.0;
    double slope = 0.0;  ///< mm per mm.
  };

  /// @pre every place from `begin` to `end` has a height, and begin < end
  SliceCurve(SliceHeights& heights, double begin, double end, const SliceDensity& density);

  [[nodiscard]] std::size_t span_count() const override { return nodes_.size() - 1; }
  [[nodiscard]] SpanRange all() const { return {0, span_count()}; }
  [[nodiscard]] cnc::contour::CurveJet at(std::size_t span, double share) const override;

  [[nodiscard]] const std::vector<Node>& nodes() const { return nodes_; }

 private:
  [[nodiscard]] bool is_straight(std::size_t span) const;

  std::vector<Node> nodes_;
  double error_mm_;
  double least_mm_;
};

}  // namespace sim::surface
