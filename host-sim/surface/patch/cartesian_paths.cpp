#include "host-sim/surface/patch/cartesian_paths.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "host-sim/surface/patch/subdivision.hpp"
#include "host-sim/surface/patch/surface_fit.hpp"

namespace sim::surface::patch {
namespace {

using Eigen::Vector3d;

/// Returns the distances of planes at `spacing` from the origin. The planes are centred between the
/// extremes of the points along the normal.
std::vector<double> planes_across(const PointGrid& grid, const Vector3d& normal, double spacing) {
  Range range{.lowest = std::numeric_limits<double>::infinity(),
              .highest = -std::numeric_limits<double>::infinity()};
  for (const Vector3d& point : grid.points) {
    range.lowest = std::min(range.lowest, normal.dot(point));
    range.highest = std::max(range.highest, normal.dot(point));
  }
  // If the width is a whole number of spacings, each spacing has a plane in its middle. The small
  // number allows for rounding.
  const double count = std::max(1.0, std::ceil(range.width() / spacing - 1.0e-9));
  const double first = 0.5 * (range.lowest + range.highest - (count - 1.0) * spacing);
  std::vector<double> planes;
  for (double i = 0.0; i < count; ++i) planes.push_back(first + i * spacing);
  return planes;
}

}  // namespace

PieceCounts piece_counts(const PatchSurface& surface, double flatness_mm) {
  const auto in_four = [&](FlatnessTest test) {
    std::size_t pieces = 0;
    for (const GridPatch& patch : surface.patches) {
      pieces += quartered(patch, FlatnessLimit{.tolerance_mm = flatness_mm, .test = test}).size();
    }
    return pieces;
  };
  return {.control_hull = in_four(FlatnessTest::kControlHull),
          .fat_plane = in_four(FlatnessTest::kFatPlane),
          .both_orders = in_four(FlatnessTest::kBothOrders),
          .fewest_halvings = flat_pieces(surface, {.tolerance_mm = flatness_mm}).size()};
}

CartesianPaths cartesian_paths(const PointGrid& grid, const PathOptions& options) {
  CartesianPaths result;
  result.surface = fitted_surface(grid, options.fit_tolerance_mm);
  result.report = fit_report(result.surface, grid, options.fit_tolerance_mm);
  result.plane_normal = {-std::sin(options.angle), std::cos(options.angle), 0.0};
  result.plane_distances_mm = planes_across(grid, result.plane_normal, options.spacing_mm);
  const PieceNet net{flat_pieces(
      result.surface,
      {.tolerance_mm = options.chord_tolerance_mm, .slicing_normal = result.plane_normal})};
  result.pieces = net.pieces().size();
  result.paths = plane_slices(net, result.plane_normal, result.plane_distances_mm);
  return result;
}

}  // namespace sim::surface::patch
