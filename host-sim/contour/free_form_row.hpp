#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "host-sim/import/curve.hpp"

namespace sim {

/// A row of shapes of a drawing as a single curve for the fit of arcs. Each shape begins at the end
/// of the previous shape. The spans of the curve are the spans of all shapes.
class FreeFormRow final : public cnc::contour::PlaneCurve {
 public:
  /// @pre the row is not empty, and the shapes outlive this object
  explicit FreeFormRow(std::span<const drawing::Shape> shapes);

  [[nodiscard]] std::size_t span_count() const override { return ends_.back(); }
  [[nodiscard]] cnc::contour::CurveJet at(std::size_t span, double share) const override;

 private:
  std::span<const drawing::Shape> shapes_;
  /// For each shape, the number of spans of the row up to the end of the shape.
  std::vector<std::size_t> ends_;
};

}  // namespace sim
