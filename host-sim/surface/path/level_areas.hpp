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

/// Finds for each level the areas within a border in which the grown tool's tip is nowhere above
/// the level, so that the tool may be there. Lengths are mm.
class LevelAreas {
 public:
  /// @param band_mm distance by which the lines of an area may leave the level set
  /// @pre tracer, tips and border outlive this object; the border's box is at least two cells
  /// inside the grid
  LevelAreas(const SurfaceTracer& tracer,
             const TipGrid& tips,
             const LevelBorder& border,
             double band_mm);

  /// Returns the lowest height of the grown tool's tip within the border, at the nodes of the grid;
  /// nothing if the surface is under none of these nodes.
  [[nodiscard]] std::optional<double> lowest_mm() const;

  /// Returns the areas of a level as contours of arcs and lines, each an outline and its islands;
  /// an empty vector if there are none. Returns nothing if a line has no closed contour within the
  /// band, for example where a gap is narrower than the cells of the grid. Areas about as small as
  /// a cell may be left out. An island as small as that may be replaced by a circle around it.
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
  std::vector<bool> is_beyond_;  ///< Whether each node is beyond the border.
  SliceFitter fitter_;
};

}  // namespace sim::surface
