#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "host-sim/contour/contour_offset.hpp"
#include "host-sim/surface/path/level_border.hpp"
#include "host-sim/surface/path/level_curve.hpp"
#include "host-sim/surface/path/level_loops.hpp"
#include "host-sim/surface/path/slice_fit.hpp"
#include "host-sim/surface/path/surface_tracer.hpp"
#include "host-sim/surface/path/tip_grid.hpp"

namespace sim::surface {

/// Finds, for each level, the areas within a border in which the tool may be at this level. In
/// these areas, the grown tool's tip in contact is nowhere above the level. Lengths are mm.
class LevelAreas {
 public:
  /// @param band_mm greatest deviation of an area's lines from the level set
  /// @pre tracer, tips and border outlive this object. The border's box is at least two cells
  /// inside the grid
  LevelAreas(const SurfaceTracer& tracer,
             const TipGrid& tips,
             const LevelBorder& border,
             double band_mm);

  /// Returns the lowest height of the grown tool's tip at the nodes within the border; nothing if
  /// the tool has no contact at these nodes.
  [[nodiscard]] std::optional<double> lowest_mm() const;

  /// Returns the areas of a level as contours of arcs and lines; an empty vector if there are none.
  /// Each contour is an outline with its islands. Returns nothing if a line has no closed contour
  /// within the band, for example where a gap is narrower than a cell of the grid. An area of about
  /// a cell's size may be left out. An island of this size may be replaced by a circle around it.
  [[nodiscard]] std::optional<std::vector<Contour>> areas_at(double level_mm);

 private:
  [[nodiscard]] std::optional<Contour> contour_at(double level_mm);
  [[nodiscard]] bool append_loop(LevelLoop& loop, const LevelSet& set, Contour& to);
  [[nodiscard]] std::vector<ContourVertex> fitted_to(const LevelCurve& curve);
  [[nodiscard]] bool joins(std::vector<ContourVertex>& line,
                           const ContourVertex& next,
                           const LevelSet& set) const;
  [[nodiscard]] bool is_tiny(const LevelLoop& loop) const;
  [[nodiscard]] bool append_circle(const LevelLoop& loop, const LevelSet& set, Contour& to) const;
  [[nodiscard]] bool is_free(const LevelSet& set,
                             const Eigen::Vector2d& from,
                             const Eigen::Vector2d& to) const;

  const SurfaceTracer* tracer_;
  const TipGrid* tips_;
  const LevelBorder* border_;
  double band_mm_;
  std::vector<bool> is_beyond_;  ///< Whether a node is beyond the border, for each node.
  SliceFitter fitter_;
};

}  // namespace sim::surface
