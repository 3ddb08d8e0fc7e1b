#include "host-sim/surface/patch/node_estimate.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <vector>

namespace sim::surface::patch {
namespace {

using Eigen::Vector3d;

/// Weights of points in a row: their sums are value and derivative of the fitted polynomial.
struct Filter {
  std::size_t first = 0;
  std::vector<double> value;
  std::vector<double> slope;
};

/// @param place of the node among `count` points, @param reach of the window to both sides
Filter filter_at(std::size_t place, std::size_t reach, std::size_t count) {
  const std::size_t length = std::min(2 * reach + 1, count);
  const std::size_t behind = std::min(reach, place);
  Filter filter{.first = std::min(place - behind, count - length), .value = {}, .slope = {}};
  // Powers of the distance from the node over the reach, so that all are of the same size.
  const auto powers = static_cast<Eigen::Index>(std::min<std::size_t>(length, 4));
  const auto points = static_cast<Eigen::Index>(length);
  Eigen::Matrix<double, Eigen::Dynamic, 4> terms(points, 4);
  const double scale = 1.0 / static_cast<double>(reach);
  for (Eigen::Index i = 0; i < points; ++i) {
    const double x = scale * (static_cast<double>(filter.first) + static_cast<double>(i) -
                              static_cast<double>(place));
    terms.row(i) << 1.0, x, x * x, x * x * x;
  }
  const auto used = terms.leftCols(powers);
  const Eigen::MatrixXd normal = used.transpose() * used;
  const Eigen::MatrixXd weights = normal.ldlt().solve(used.transpose());
  for (Eigen::Index i = 0; i < points; ++i) {
    filter.value.push_back(weights(0, i));
    filter.slope.push_back(scale * weights(1, i));
  }
  return filter;
}

}  // namespace

Node estimated_node(const PointGrid& grid, const NodeWindow& window) {
  const Filter down = filter_at(window.row, window.rows, grid.rows);
  const Filter along = filter_at(window.column, window.columns, grid.columns);
  Node node;
  for (std::size_t i = 0; i < down.value.size(); ++i) {
    Vector3d point = Vector3d::Zero();
    Vector3d slope = Vector3d::Zero();
    const Vector3d* row = &grid.at(down.first + i, along.first);
    for (std::size_t j = 0; j < along.value.size(); ++j) {
      point += along.value[j] * row[j];
      slope += along.slope[j] * row[j];
    }
    node.point += down.value[i] * point;
    node.along_u += down.slope[i] * point;
    node.along_v += down.value[i] * slope;
    node.twist += down.slope[i] * slope;
  }
  if (window.rows == 1 && window.columns == 1) node.point = grid.at(window.row, window.column);
  return node;
}

}  // namespace sim::surface::patch
