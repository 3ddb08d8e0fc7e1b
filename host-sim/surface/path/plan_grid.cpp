#include "host-sim/surface/path/plan_grid.hpp"

#include <fmt/format.h>

#include <cmath>
#include <stdexcept>

namespace sim::surface {

PlanGrid::PlanGrid(const Mesh& mesh, double margin_mm, double max_pitch_mm) {
  Eigen::Vector2d least = mesh.points.front().head<2>();
  Eigen::Vector2d most = least;
  for (const Eigen::Vector3d& point : mesh.points) {
    least = least.cwiseMin(point.head<2>());
    most = most.cwiseMax(point.head<2>());
  }
  min_ = least.array() - margin_mm;
  const Eigen::Vector2d size = (most - least).array() + 2.0 * margin_mm;
  const Eigen::Vector2d cells = (size / max_pitch_mm).array().ceil().max(1.0);
  const double nodes = (cells.x() + 1.0) * (cells.y() + 1.0);
  if (!(nodes <= kMaxNodes)) {
    throw std::invalid_argument{
        fmt::format("paths along contours need a grid of {:g} mm for this tool and step, which "
                    "has {:.3g} points on {:g} x {:g} mm; the maximum is {:g}, so mill the surface "
                    "in parts or in rows",
                    max_pitch_mm,
                    nodes,
                    size.x(),
                    size.y(),
                    kMaxNodes)};
  }
  pitch_ = size.cwiseQuotient(cells);
  columns_ = static_cast<std::size_t>(cells.x()) + 1;
  rows_ = static_cast<std::size_t>(cells.y()) + 1;
}

}  // namespace sim::surface
