#include "host-sim/surface/patch/surface_fit.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include "host-sim/surface/patch/cell_tree.hpp"
#include "host-sim/surface/patch/grid_distance.hpp"
#include "host-sim/surface/patch/node_estimate.hpp"
#include "host-sim/surface/patch/surface_distance.hpp"

namespace sim::surface::patch {
namespace {

using Eigen::Vector3d;

/// Returns the patch of a cell from the nodes at its corners. Their order is (row, column), (row,
/// end column), (end row, column), (end row, end column).
BezierPatch hermite_patch(const Cell& cell, const std::array<const Node*, 4>& corners) {
  BezierPatch patch;
  for (std::size_t corner = 0; corner < 4; ++corner) {
    const Node& node = *corners[corner];
    const bool is_end_u = corner >= 2;
    const bool is_end_v = corner % 2 == 1;
    const double third_u = (is_end_u ? -1.0 : 1.0) * cell.height() / 3.0;
    const double third_v = (is_end_v ? -1.0 : 1.0) * cell.width() / 3.0;
    const std::size_t u = is_end_u ? 3 : 0;
    const std::size_t v = is_end_v ? 3 : 0;
    const std::size_t inner_u = is_end_u ? 2 : 1;
    const std::size_t inner_v = is_end_v ? 2 : 1;
    const Vector3d across = node.point + third_u * node.along_u;
    patch.rows[u].controls[v] = node.point;
    patch.rows[inner_u].controls[v] = across;
    patch.rows[u].controls[inner_v] = node.point + third_v * node.along_v;
    patch.rows[inner_u].controls[inner_v] =
        across + third_v * (node.along_v + third_u * node.twist);
  }
  return patch;
}

/// Builds the patches of all cells of a tree, in the order of the cells' numbers.
class PatchBuilder {
 public:
  PatchBuilder(const PointGrid& grid, const CellTree& tree)
      : grid_{grid}, tree_{tree}, node_numbers_(grid.points.size(), kNone) {}

  std::vector<BezierPatch> patches() {
    const std::vector<Cell>& cells = tree_.cells();
    std::vector<std::uint32_t> order(cells.size());
    for (std::uint32_t i = 0; i < order.size(); ++i) order[i] = i;
    // Builds coarse cells first, because a hanging corner needs the border of the coarser patch.
    std::stable_sort(order.begin(), order.end(), [&cells](std::uint32_t a, std::uint32_t b) {
      return cells[a].depth < cells[b].depth;
    });
    patches_.resize(cells.size());
    for (const std::uint32_t number : order) {
      const Cell& cell = cells[number];
      const std::array<std::uint32_t, 4> corners{node_at(cell.row, cell.column),
                                                 node_at(cell.row, cell.end_column),
                                                 node_at(cell.end_row, cell.column),
                                                 node_at(cell.end_row, cell.end_column)};
      patches_[number] = hermite_patch(
          cell,
          {&nodes_[corners[0]], &nodes_[corners[1]], &nodes_[corners[2]], &nodes_[corners[3]]});
    }
    return std::move(patches_);
  }

 private:
  static constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();

  std::uint32_t node_at(std::uint32_t row, std::uint32_t column) {
    std::uint32_t& number = node_numbers_[row * grid_.columns + column];
    if (number == kNone) {
      number = static_cast<std::uint32_t>(nodes_.size());
      nodes_.push_back(new_node(row, column));
    }
    return number;
  }

  Node new_node(std::uint32_t row, std::uint32_t column) const {
    std::uint32_t height = std::numeric_limits<std::uint32_t>::max();
    std::uint32_t width = height;
    for (const std::uint32_t number : tree_.cells_around(row, column)) {
      const Cell& cell = tree_.cells()[number];
      if (!cell.has_corner(row, column)) return hanging_node(number, row, column);
      height = std::min(height, cell.height());
      width = std::min(width, cell.width());
    }
    return estimated_node(grid_, {row, column, height, width});
  }

  /// Computes the node of a hanging corner from the patch of the coarser cell `number`.
  Node hanging_node(std::uint32_t number, std::uint32_t row, std::uint32_t column) const {
    const Cell& cell = tree_.cells()[number];
    const double height = cell.height();
    const double width = cell.width();
    const PatchJet jet =
        patches_[number].jet((row - cell.row) / height, (column - cell.column) / width);
    return {jet.point, jet.along_u / height, jet.along_v / width, jet.twist / (height * width)};
  }

  const PointGrid& grid_;
  const CellTree& tree_;
  std::vector<std::uint32_t> node_numbers_;
  std::vector<Node> nodes_;
  std::vector<BezierPatch> patches_;
};

/// A point of the grid whose distance from the patch's point with the same row and column exceeds
/// the tolerance. The nearest point of the surface may still be within tolerance.
struct Suspect {
  std::uint32_t row = 0;
  std::uint32_t column = 0;
  double distance = 0.0;
};

/// Fits a surface: splits cells until the surface is within tolerance of all points.
class AdaptiveFit {
 public:
  AdaptiveFit(const PointGrid& grid, double tolerance)
      : grid_{grid}, tolerance_{tolerance}, tree_{grid.rows, grid.columns} {}

  PatchSurface surface() {
    build();
    // The loop ends, because each pass splits at least one cell and no cell is smaller than a
    // quadrilateral.
    while (split_failing_cells()) build();
    return std::move(surface_);
  }

 private:
  void build() {
    const std::vector<BezierPatch> shapes = PatchBuilder{grid_, tree_}.patches();
    surface_ = {grid_.rows, grid_.columns, {}};
    surface_.patches.reserve(shapes.size());
    for (std::size_t i = 0; i < shapes.size(); ++i) {
      const Cell& cell = tree_.cells()[i];
      surface_.patches.push_back(
          {{static_cast<double>(cell.row), static_cast<double>(cell.end_row)},
           {static_cast<double>(cell.column), static_cast<double>(cell.end_column)},
           shapes[i]});
    }
    distance_.reset();
  }

  bool split_failing_cells() {
    const std::vector<Cell> before = tree_.cells();
    std::vector<std::uint32_t> failing;
    for (std::uint32_t number = 0; number < before.size(); ++number) {
      const std::optional<Suspect> point = failing_point(number);
      if (!point) continue;
      const std::vector<std::uint32_t> around = tree_.cells_around(point->row, point->column);
      failing.insert(failing.end(), around.begin(), around.end());
    }
    bool has_split = false;
    for (const std::uint32_t number : failing) {
      const Cell& cell = tree_.cells()[number];
      if (cell.depth != before[number].depth || !cell.can_be_split()) continue;
      tree_.split(number);
      has_split = true;
    }
    return has_split;
  }

  /// Returns a point of a cell whose distance from the complete surface exceeds the tolerance, or
  /// at which the surface is not near the grid.
  std::optional<Suspect> failing_point(std::uint32_t number) {
    std::vector<Suspect> suspects = suspects_of(number);
    std::sort(suspects.begin(), suspects.end(), [](const Suspect& a, const Suspect& b) {
      return a.distance > b.distance;
    });
    const Cell& cell = tree_.cells()[number];
    for (const Suspect& suspect : suspects) {
      if (!distance_) distance_.emplace(surface_);
      const SurfacePoint near{number,
                              (suspect.row - cell.row) / static_cast<double>(cell.height()),
                              (suspect.column - cell.column) / static_cast<double>(cell.width()),
                              suspect.distance};
      if (!distance_->is_within(grid_.at(suspect.row, suspect.column), tolerance_, near) ||
          !is_near_grid(near, suspect.row, suspect.column)) {
        return suspect;
      }
    }
    return std::nullopt;
  }

  /// Returns whether the surface at a row and column is within tolerance of the nearest
  /// quadrilaterals of the grid. Without this check, the surface could bulge between the points and
  /// still pass near them.
  bool is_near_grid(const SurfacePoint& place, std::uint32_t row, std::uint32_t column) const {
    const Vector3d point = surface_.patches[place.patch].shape.at(place.u, place.v);
    const auto last_row = static_cast<std::uint32_t>(grid_.rows - 2);
    const auto last_column = static_cast<std::uint32_t>(grid_.columns - 2);
    for (std::uint32_t r = row - std::min(row, 2U); r <= std::min(row + 1, last_row); ++r) {
      for (std::uint32_t c = column - std::min(column, 2U); c <= std::min(column + 1, last_column);
           ++c) {
        if (square_distance_from(grid_, r, c, point) <= tolerance_ * tolerance_) return true;
      }
    }
    return false;
  }

  std::vector<Suspect> suspects_of(std::uint32_t number) const {
    const Cell& cell = tree_.cells()[number];
    std::vector<Suspect> suspects;
    for (std::uint32_t row = cell.row; row <= cell.end_row; ++row) {
      const BezierCurve curve = surface_.patches[number].shape.curve_at_u(
          (row - cell.row) / static_cast<double>(cell.height()));
      for (std::uint32_t column = cell.column; column <= cell.end_column; ++column) {
        const Vector3d off = grid_.at(row, column) -
                             curve.at((column - cell.column) / static_cast<double>(cell.width()));
        // The negated condition also finds NaN, which results if the surface exceeds the range of
        // doubles.
        if (!(off.squaredNorm() <= tolerance_ * tolerance_)) {
          suspects.push_back({row, column, off.norm()});
        }
      }
    }
    return suspects;
  }

  const PointGrid& grid_;
  double tolerance_;
  CellTree tree_;
  PatchSurface surface_;
  /// Distances from the current surface; created when first needed.
  std::optional<SurfaceDistance> distance_;
};

}  // namespace

PatchSurface fitted_surface(const PointGrid& grid, double tolerance_mm) {
  return AdaptiveFit{grid, tolerance_mm}.surface();
}

}  // namespace sim::surface::patch
