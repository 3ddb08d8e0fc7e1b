#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "host-sim/import/curve.hpp"

namespace sim {

/// Shapes of a drawing in a row, each from the end of the previous shape, as one curve for the fit.
/// The curve has the spans of all shapes.
class FreeFormRow final : public cnc::contour::PlaneCurve {
 public:
  /// @pre the row is not empty, and the shapes outlive this object
  explicit FreeFormRow(std::span<const drawing::Shape> shapes);

  [[nodiscard]] std::size_t span_count() const override { return ends_.back(); }
  [[nodiscard]] cnc::contour::CurveJet at(std::size_t span, double share) const override;

 private:
  std::span<const drawing::Shape> shapes_;
  /// For each shape, the number of the span after its last span in the row.
  std::vector<std::size_t> ends_;
};

}  // namespace sim
