#include "host-sim/surface/grid_repair.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "host-sim/surface/refusal.hpp"

namespace sim::surface {
namespace {

constexpr int kMaxSweeps = 1'000;
/// Factor of over-relaxation. For large holes, the number of sweeps is about the square root of the
/// number that plain averages need.
constexpr double kRelaxation = 1.7;
/// Change of a height at which the sweeps end, relative to the range of heights.
constexpr double kAgreement = 1.0e-6;

/// Returns the mean of the known heights of the four neighbours of a point in its row and column;
/// NaN if no neighbour is known.
double mean_around(const GridDraft& grid, std::size_t index) {
  double sum = 0.0;
  int count = 0;
  const auto take = [&](bool is_inside, std::size_t other) {
    if (!is_inside || grid.is_missing(other)) return;
    sum += grid.points[other].z();
    ++count;
  };
  const std::size_t column = index % grid.columns;
  take(column > 0, index - 1);
  take(column + 1 < grid.columns, index + 1);
  take(index >= grid.columns, index - grid.columns);
  take(index + grid.columns < grid.points.size(), index + grid.columns);
  return count == 0 ? std::numeric_limits<double>::quiet_NaN() : sum / count;
}

/// Gives each missing point an initial height, the mean of its neighbours with known heights. Fills
/// a hole in layers, from its rim inwards.
void fill_by_layers(GridDraft& grid, std::vector<std::size_t> missing) {
  std::vector<double> heights;
  while (!missing.empty()) {
    heights.clear();
    for (const std::size_t index : missing) heights.push_back(mean_around(grid, index));
    std::size_t left = 0;
    for (std::size_t i = 0; i < heights.size(); ++i) {
      grid.points[missing[i]].z() = heights[i];
      if (std::isnan(heights[i])) missing[left++] = missing[i];
    }
    if (left == missing.size()) return;
    missing.resize(left);
  }
}

/// Does one sweep: moves the height of each filled point towards the mean of its neighbours.
/// Returns the greatest change.
double relax(GridDraft& grid, const std::vector<std::size_t>& filled) {
  double greatest = 0.0;
  for (const std::size_t index : filled) {
    const double change = kRelaxation * (mean_around(grid, index) - grid.points[index].z());
    grid.points[index].z() += change;
    greatest = std::max(greatest, std::abs(change));
  }
  return greatest;
}

}  // namespace

void fill_missing(GridDraft& grid) {
  std::vector<std::size_t> missing;
  double least = std::numeric_limits<double>::infinity();
  double greatest = -least;
  for (std::size_t i = 0; i < grid.points.size(); ++i) {
    if (grid.is_missing(i)) missing.push_back(i);
    least = std::fmin(least, grid.points[i].z());
    greatest = std::fmax(greatest, grid.points[i].z());
  }
  if (missing.empty()) return;
  if (2 * missing.size() > grid.points.size()) {
    refuse(grid.name,
           0,
           fmt::format("lacks {} of {} heights", missing.size(), grid.points.size()),
           "measure more than half of the points");
  }
  fill_by_layers(grid, missing);
  const double agreement = kAgreement * (greatest - least);
  for (int sweep = 0; sweep < kMaxSweeps; ++sweep) {
    if (relax(grid, missing) <= agreement) return;
  }
}

}  // namespace sim::surface
