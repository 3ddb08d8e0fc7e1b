#include "host-sim/surface/lattice.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "host-sim/surface/median.hpp"

namespace sim::surface {
namespace {

/// Maximum distance of a point from its grid point, relative to the pitch.
constexpr double kLatticeTolerance = 0.1;

/// A regular grid, whose points are origin + column · along + row · across.
struct Lattice {
  Eigen::Vector2d origin{0.0, 0.0};
  Eigen::Vector2d along{0.0, 0.0};
  Eigen::Vector2d across{0.0, 0.0};

  [[nodiscard]] Eigen::Vector2d place(double row, double column) const {
    return origin + column * along + row * across;
  }
  /// Returns column and row of a point as real numbers.
  [[nodiscard]] Eigen::Vector2d coordinates(const Eigen::Vector2d& point) const {
    const Eigen::Vector2d from = point - origin;
    return {from.dot(along) / along.squaredNorm(), from.dot(across) / across.squaredNorm()};
  }
};

/// Returns the length nearest to `step` that divides `length` into equal parts; 0 if `length` is
/// less than half of `step`. Rounded coordinates distort single steps, but not their sum.
double whole_part(double length, double step) {
  const double count = std::round(length / step);
  return std::isfinite(count) && count != 0.0 ? length / count : 0.0;
}

/// Returns a lattice along the longest row. Its pitches are the median steps along and across this
/// row, and its origin is the first point. Returns nothing if the points do not form a lattice.
std::optional<Lattice> fitted_lattice(const XyzTable& table, const std::vector<ScanRow>& rows) {
  const auto longest = std::ranges::max_element(rows, {}, &ScanRow::size);
  if (longest->size() < 2 || rows.size() < 2) return {};
  const auto plan = [&](std::size_t index) -> Eigen::Vector2d {
    return table.points[index].head<2>();
  };
  Eigen::Vector2d along = plan(longest->index(longest->size() - 1)) - plan(longest->index(0));
  if (along.norm() == 0.0) return {};
  along.normalize();
  const Eigen::Vector2d across{-along.y(), along.x()};
  std::vector<double> steps;
  std::vector<double> distances;
  for (std::size_t r = 0; r < rows.size(); ++r) {
    for (std::size_t i = 1; i < rows[r].size(); ++i) {
      steps.push_back((plan(rows[r].index(i)) - plan(rows[r].index(i - 1))).dot(along));
    }
    if (r == 0) continue;
    distances.push_back((plan(rows[r].begin) - plan(rows[r - 1].begin)).dot(across));
  }
  const double length =
      (plan(longest->index(longest->size() - 1)) - plan(longest->index(0))).norm();
  const double width = (plan(rows.back().begin) - plan(0)).dot(across);
  const double pitch = whole_part(length, median_of(steps));
  const double distance = whole_part(width, median_of(distances));
  if (!(pitch > 0.0) || !(std::abs(distance) > 0.0)) return {};
  return Lattice{plan(0), pitch * along, distance * across};
}

/// Lowest and highest column and row of the points.
struct LatticeBounds {
  Eigen::Vector2d least{0.0, 0.0};
  Eigen::Vector2d greatest{0.0, 0.0};
};

/// Returns the range of columns and rows that the points occupy; nothing if a point is too far from
/// its grid point.
std::optional<LatticeBounds> bounds_on(const Lattice& lattice, const XyzTable& table) {
  LatticeBounds bounds;
  for (const Eigen::Vector3d& point : table.points) {
    const Eigen::Vector2d at = lattice.coordinates(point.head<2>());
    const Eigen::Vector2d whole = at.array().round();
    // The negated condition also refuses NaN.
    if (!((at - whole).cwiseAbs().maxCoeff() <= kLatticeTolerance)) return {};
    bounds.least = bounds.least.cwiseMin(whole);
    bounds.greatest = bounds.greatest.cwiseMax(whole);
  }
  return bounds;
}

}  // namespace

std::optional<GridDraft> lattice_of(const XyzTable& table,
                                    const std::vector<ScanRow>& rows,
                                    const std::string& name) {
  const auto lattice = fitted_lattice(table, rows);
  if (!lattice) return {};
  const auto bounds = bounds_on(*lattice, table);
  if (!bounds) return {};
  const Eigen::Vector2d extent = bounds->greatest - bounds->least + Eigen::Vector2d::Ones();
  if (extent.minCoeff() < 2.0 || extent.prod() > 2.0 * static_cast<double>(table.points.size())) {
    return {};
  }
  GridDraft grid{.name = name,
                 .rows = static_cast<std::size_t>(extent.y()),
                 .columns = static_cast<std::size_t>(extent.x())};
  grid.points.resize(grid.rows * grid.columns);
  grid.lines.resize(grid.points.size());
  for (std::size_t i = 0; i < grid.points.size(); ++i) {
    const std::size_t rows_below = i / grid.columns;
    const double row = static_cast<double>(rows_below) + bounds->least.y();
    const double column = static_cast<double>(i % grid.columns) + bounds->least.x();
    grid.points[i] << lattice->place(row, column), std::numeric_limits<double>::quiet_NaN();
  }
  for (std::size_t i = 0; i < table.points.size(); ++i) {
    const Eigen::Vector2d at = lattice->coordinates(table.points[i].head<2>()) - bounds->least;
    const auto index = static_cast<std::size_t>(std::lround(at.y())) * grid.columns +
                       static_cast<std::size_t>(std::lround(at.x()));
    if (grid.lines[index] != 0) return {};
    grid.points[index] = table.points[i];
    grid.lines[index] = table.lines[i];
  }
  return grid;
}

}  // namespace sim::surface
