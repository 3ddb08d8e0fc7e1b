#include "host-sim/stock/distance_map.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace sim::stock {
namespace {

constexpr double kNoDistance = std::numeric_limits<double>::infinity();

/// Applies the distance transform to one line of a grid of squared distances.
class ParabolaLine {
 public:
  ParabolaLine(std::size_t max_cells, double spacing_mm)
      : square_mm2_{spacing_mm * spacing_mm}, values_(max_cells), foot_(max_cells) {
    from_.resize(max_cells + 1);
  }

  /// Replaces `count` values whose indices are `stride` apart. For each cell of the line, computes
  /// the cell's old value plus its squared distance from a given cell. The new value of the given
  /// cell is the minimum of these sums.
  void spread(double* values, std::size_t count, std::size_t stride) {
    std::size_t parabolas = 0;
    for (std::size_t i = 0; i < count; ++i) {
      values_[i] = values[i * stride];
      if (values_[i] < kNoDistance) parabolas = add(parabolas, i);
    }
    if (parabolas == 0) return;
    std::size_t current = 0;
    for (std::size_t i = 0; i < count; ++i) {
      const auto place = static_cast<double>(i);
      while (current + 1 < parabolas && from_[current + 1] < place) ++current;
      const double off = place - static_cast<double>(foot_[current]);
      values[i * stride] = values_[foot_[current]] + off * off * square_mm2_;
    }
  }

 private:
  /// Returns the position, in cells, beyond which the parabola over `right` is below the parabola
  /// over `left`.
  [[nodiscard]] double crossing(std::size_t left, std::size_t right) const {
    const auto a = static_cast<double>(left);
    const auto b = static_cast<double>(right);
    const double rise = (values_[right] - values_[left]) / square_mm2_;
    return (rise + b * b - a * a) / (2.0 * (b - a));
  }

  /// Adds the parabola over cell `place` to the lower envelope of `parabolas` parabolas. Returns
  /// the new number of parabolas in the envelope.
  std::size_t add(std::size_t parabolas, std::size_t place) {
    double from = -kNoDistance;
    while (parabolas > 0) {
      from = crossing(foot_[parabolas - 1], place);
      if (from > from_[parabolas - 1]) break;
      --parabolas;
      from = -kNoDistance;
    }
    foot_[parabolas] = place;
    from_[parabolas] = from;
    return parabolas + 1;
  }

  double square_mm2_;
  std::vector<double> values_;
  std::vector<std::size_t> foot_;  ///< Cell of each parabola in the envelope.
  /// Position, in cells, at which each parabola begins to be the lowest.
  std::vector<double> from_;
};

}  // namespace

std::vector<double> distances_to(const std::vector<bool>& marked, const DistanceGrid& grid) {
  std::vector<double> squares(grid.size());
  for (std::size_t i = 0; i < squares.size(); ++i) squares[i] = marked[i] ? 0.0 : kNoDistance;
  const auto columns = static_cast<std::size_t>(grid.columns);
  const auto rows = static_cast<std::size_t>(grid.rows);
  ParabolaLine column{rows, grid.cell_y_mm};
  for (std::size_t i = 0; i < columns; ++i) column.spread(squares.data() + i, rows, columns);
  ParabolaLine row{columns, grid.cell_x_mm};
  for (std::size_t i = 0; i < rows; ++i) row.spread(squares.data() + i * columns, columns, 1);
  for (double& square : squares) square = std::sqrt(square);
  return squares;
}

}  // namespace sim::stock
