#include "host-sim/surface/patch/node_estimate.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <vector>

namespace sim::surface::patch {
namespace {

using Eigen::Vector3d;

/// Weights of the points in a row or column, beginning at index `first`. The sums of the weighted
/// points are the value and the derivative of the fitted polynomial.
struct Filter {
  std::size_t first = 0;
  std::vector<double> value;
  std::vector<double> slope;
};

/// Computes the weights for a node.
/// @param place index of the node among `count` points
/// @param reach number of points of the window on each side of the node
Filter filter_at(std::size_t place, std::size_t reach, std::size_t count) {
  const std::size_t length = std::min(2 * reach + 1, count);
  const std::size_t behind = std::min(reach, place);
  Filter filter{.first = std::min(place - behind, count - length), .value = {}, .slope = {}};
  // Dividing distances from the node by the reach gives all powers a similar size.
  const double scale = 1.0 / static_cast<double>(reach);
  const auto powers_at = [&](std::size_t i) {
    const double x = scale * (static_cast<double>(filter.first + i) - static_cast<double>(place));
    // If the window has few points, they determine only the coefficients of the lower powers.
    return Eigen::Vector4d{1.0, x, length > 2 ? x * x : 0.0, length > 3 ? x * x * x : 0.0};
  };
  Eigen::Matrix4d normal = Eigen::Matrix4d::Zero();
  for (std::size_t i = 0; i < length; ++i) normal += powers_at(i) * powers_at(i).transpose();
  for (Eigen::Index i = 2; i < 4; ++i) {
    if (normal(i, i) == 0.0) normal(i, i) = 1.0;
  }
  const Eigen::Matrix4d inverse = normal.ldlt().solve(Eigen::Matrix4d::Identity());
  filter.value.reserve(length);
  filter.slope.reserve(length);
  for (std::size_t i = 0; i < length; ++i) {
    const Eigen::Vector4d powers = powers_at(i);
    filter.value.push_back(inverse.row(0).dot(powers));
    filter.slope.push_back(scale * inverse.row(1).dot(powers));
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
