#include "host-sim/surface/outliers.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "host-sim/surface/median.hpp"

namespace sim::surface {
namespace {

/// Minimum difference of an outlier from its neighbours' median, relative to the spread. Normally
/// distributed noise reaches a factor of 6.
constexpr double kOutlierFactor = 8.0;
/// Number of standard deviations that nine of ten distances from the mean of a normal distribution
/// do not exceed.
constexpr double kSigmasOfNineTenths = 1.645;
/// Lower limit of the spread, relative to the distance between points.
constexpr double kMinSpread = 0.02;
/// Minimum number of known neighbours for the check of a point.
constexpr std::size_t kMinNeighbours = 3;

/// Known heights of the up to eight neighbours of a point, sorted.
struct Neighbours {
  std::array<double, 8> heights{};
  std::size_t count = 0;

  [[nodiscard]] double median() const {
    const double upper = heights[count / 2];
    return count % 2 == 1 ? upper : 0.5 * (heights[count / 2 - 1] + upper);
  }
  [[nodiscard]] double range() const {
    const std::size_t cut = count == heights.size() ? 1 : 0;
    return heights[count - 1 - cut] - heights[cut];
  }
  [[nodiscard]] std::size_t count_near(double height, double distance) const {
    const auto* const end = heights.begin() + count;
    return static_cast<std::size_t>(std::count_if(
        heights.begin(), end, [&](double other) { return std::abs(other - height) <= distance; }));
  }
};

Neighbours neighbours_of(const GridDraft& grid, std::size_t row, std::size_t column) {
  Neighbours around;
  for (std::size_t r = row - std::min<std::size_t>(row, 1); r <= row + 1 && r < grid.rows; ++r) {
    const std::size_t first = column - std::min<std::size_t>(column, 1);
    for (std::size_t c = first; c <= column + 1 && c < grid.columns; ++c) {
      const double height = grid.at(r, c).z();
      if ((r == row && c == column) || std::isnan(height)) continue;
      around.heights[around.count++] = height;
    }
  }
  std::sort(around.heights.begin(), around.heights.begin() + around.count);
  return around;
}

/// Returns the median distance in plan between neighbours in a row.
double median_step(const GridDraft& grid) {
  std::vector<double> steps;
  for (std::size_t i = 1; i < grid.points.size(); ++i) {
    if (i % grid.columns == 0) continue;
    steps.push_back((grid.points[i] - grid.points[i - 1]).head<2>().norm());
  }
  return median_of(steps);
}

/// Returns the spread, mm: the standard deviation of all heights from the medians of their
/// neighbours.
double spread_of(const GridDraft& grid) {
  std::vector<double> distances;
  for (std::size_t i = 0; i < grid.points.size(); ++i) {
    if (grid.is_missing(i)) continue;
    const Neighbours around = neighbours_of(grid, i / grid.columns, i % grid.columns);
    if (around.count < kMinNeighbours) continue;
    distances.push_back(std::abs(grid.points[i].z() - around.median()));
  }
  double nine_tenths = 0.0;
  if (!distances.empty()) {
    const auto at = distances.begin() + static_cast<std::ptrdiff_t>(distances.size() * 9 / 10);
    std::nth_element(distances.begin(), at, distances.end());
    nine_tenths = *at;
  }
  return std::max(nine_tenths / kSigmasOfNineTenths, kMinSpread * median_step(grid));
}

}  // namespace

std::vector<std::size_t> outliers_of(const GridDraft& grid) {
  const double spread = spread_of(grid);
  std::vector<std::size_t> outliers;
  for (std::size_t i = 0; i < grid.points.size(); ++i) {
    if (grid.is_missing(i)) continue;
    const double height = grid.points[i].z();
    const Neighbours around = neighbours_of(grid, i / grid.columns, i % grid.columns);
    if (around.count < kMinNeighbours) continue;
    const double farthest = kOutlierFactor * std::max(spread, around.range());
    if (!(std::abs(height - around.median()) > farthest)) continue;
    if (around.count_near(height, farthest) < 2) outliers.push_back(i);
  }
  return outliers;
}

}  // namespace sim::surface
