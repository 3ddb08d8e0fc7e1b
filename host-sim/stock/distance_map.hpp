#pragma once

#include <cstddef>
#include <vector>

namespace sim::stock {

/// Size of a grid of equal rectangles, stored row by row.
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

/// Returns for each cell the distance from its centre to the nearest centre of a marked cell, mm.
/// The distance is 0 for marked cells, and infinite if no cell is marked. The computing time is
/// proportional to the number of cells. Each cell takes 8 bytes.
///
/// Source: P. Felzenszwalb, D. Huttenlocher, "Distance Transforms of Sampled Functions", Theory of
/// Computing 8 (2012): the lower envelope of parabolas, first along columns, then along rows.
/// @pre marked.size() == grid.size()
[[nodiscard]] std::vector<double> distances_to(const std::vector<bool>& marked,
                                               const DistanceGrid& grid);

}  // namespace sim::stock
