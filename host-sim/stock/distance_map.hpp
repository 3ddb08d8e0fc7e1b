#pragma once

#include <cstddef>
#include <vector>

namespace sim::stock {

/// Distances over a grid of equal rectangles, row by row.
struct DistanceGrid {
  int columns = 0;
  int rows = 0;
  double cell_x_mm = 0.0;
  double cell_y_mm = 0.0;

  [[nodiscard]] std::size_t size() const {
    return static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows);
  }
  [[nodiscard]] std::size_t index(int column, int row) const {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(columns) +
           static_cast<std::size_t>(column);
  }
};

/// The distance from the centre of each cell to the nearest centre of a marked one, mm; 0 for these
/// and infinite if there are none. Takes time in proportion to the cells, and 8 bytes for each.
///
/// Source: P. Felzenszwalb, D. Huttenlocher, "Distance Transforms of Sampled Functions", Theory of
/// Computing 8 (2012), the lower envelope of parabolas, first along columns, then along rows.
/// @pre marked.size() == grid.size()
[[nodiscard]] std::vector<double> distances_to(const std::vector<bool>& marked,
                                               const DistanceGrid& grid);

}  // namespace sim::stock
