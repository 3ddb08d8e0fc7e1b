#pragma once

#include <vector>

#include "host-sim/surface/path/row_frame.hpp"
#include "host-sim/surface/path/surface_tracer.hpp"

namespace sim::surface {

/// Returns the greatest distance between rows at which a tool leaves at most `scallop_mm` on a
/// level surface. The distance is at most 1.6 times the tool's radius.
[[nodiscard]] double level_step(const cnc::surface::Profile& tool, double scallop_mm);

/// Returns the distance between neighbouring lines. It is the smaller of the step in the options
/// and the distance that limits the scallops on a level surface.
[[nodiscard]] double step_of(const RowOptions& options);

/// Finds additional rows between two rows where a surface is so steep across the rows that the
/// stock between them exceeds the limit.
class ScallopRows {
 public:
  /// @param scallop_mm greatest height of the stock between rows, perpendicular to the surface,
  /// above 0
  /// @pre the tracer outlives this object
  ScallopRows(const SurfaceTracer& tracer,
              const RowFrame& frame,
              const cnc::surface::Profile& tool,
              double scallop_mm);

  /// Returns the parts of additional rows between two rows. Each additional row is half way between
  /// two other rows.
  [[nodiscard]] std::vector<RowPart> between(double low_row, double high_row) const;

 private:
  struct Gap {
    RowPart low;  ///< Lower row of the gap, with the part along the row that is checked.
    double high_row = 0.0;
    int depth = 0;
  };

  class Strip;

  /// Returns the distance by which an additional row extends beyond the points where the limit is
  /// exceeded.
  [[nodiscard]] double overlap_mm() const { return 0.25 * tool_.radius_mm; }
  void divide(const Gap& gap, std::vector<Gap>& pending, std::vector<RowPart>& parts) const;

  const SurfaceTracer* tracer_;
  RowFrame frame_;
  cnc::surface::Profile tool_;
  double scallop_mm_;
  double look_mm_;
};

}  // namespace sim::surface
