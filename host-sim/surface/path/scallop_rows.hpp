#pragma once

#include <vector>

#include "host-sim/surface/path/row_frame.hpp"
#include "host-sim/surface/path/surface_tracer.hpp"

namespace sim::surface {

/// Returns the distance of rows between which a tool leaves no more than `scallop_mm` on a level
/// surface; at most 1.6 of its radius.
[[nodiscard]] double level_step(const cnc::surface::Profile& tool, double scallop_mm);

/// Returns the distance of lines side by side: asked for, or by which a level surface has no higher
/// scallops.
[[nodiscard]] double step_of(const RowOptions& options);

/// Rows between others where a surface is so steep across that the stock between would be higher
/// than asked for.
class ScallopRows {
 public:
  /// @param scallop_mm greatest height of the stock between rows, at right angles to the surface,
  /// above 0
  /// @pre the tracer outlives this
  ScallopRows(const SurfaceTracer& tracer,
              const RowFrame& frame,
              const cnc::surface::Profile& tool,
              double scallop_mm);

  /// Returns the parts of rows that are needed between two rows, each half way between two others.
  [[nodiscard]] std::vector<RowPart> between(double low_row, double high_row) const;

 private:
  struct Gap {
    RowPart low;  ///< And from where to where it is looked at.
    double high_row = 0.0;
    int depth = 0;
  };

  class Strip;

  /// A part of a row goes on so far beyond where it is needed.
  [[nodiscard]] double overlap_mm() const { return 0.25 * tool_.radius_mm; }
  void divide(const Gap& gap, std::vector<Gap>& pending, std::vector<RowPart>& parts) const;

  const SurfaceTracer* tracer_;
  RowFrame frame_;
  cnc::surface::Profile tool_;
  double scallop_mm_;
  double look_mm_;
};

}  // namespace sim::surface
