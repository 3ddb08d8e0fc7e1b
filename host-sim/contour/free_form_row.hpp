#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "host-sim/import/curve.hpp"

namespace sim {

/// Shapes of a drawing in a row, each from the end of the one before, as one curve
/// for the fit: the spans of all of them.
class FreeFormRow final : public cnc::contour::PlaneCurve {
 public:
  /// @pre not empty; the shapes outlive this.
  explicit FreeFormRow(std::span<const drawing::Shape> shapes);

  [[nodiscard]] std::size_t span_count() const override { return ends_.back(); }
  [[nodiscard]] cnc::contour::CurveJet at(std::size_t span, double share) const override;

 private:
  std::span<const drawing::Shape> shapes_;
  std::vector<std::size_t> ends_;  ///< Of each shape: one past its last span in the row.
};

}  // namespace sim
