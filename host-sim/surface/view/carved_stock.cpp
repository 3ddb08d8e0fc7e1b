#include "host-sim/surface/view/carved_stock.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "host-sim/stock/carver.hpp"
#include "host-sim/stock/surface_comparison.hpp"
#include "host-sim/surface/path/surface_program.hpp"
#include "host-sim/surface/view/stretch_line.hpp"

namespace sim::surface {
namespace {

/// Approximate number of cells of a block if no cell size is given.
constexpr double kBlockCells = 6.0e5;
constexpr double kMinBlockCellMm = 0.01;

stock::Pose pose_of(const Eigen::Vector3d& point) { return {point.x(), point.y(), point.z()}; }

}  // namespace

stock::Stock block_for(const Mesh& mesh, const SurfacePath& path, const BlockOptions& options) {
  SpaceBox box;
  for (const Eigen::Vector3d& point : mesh.points) box.include(point);
  const Eigen::Vector3d size = box.most - box.least;
  const double lowest = std::min(box.least.z(), figures_of(path).lowest_mm);
  const double top = options.top_mm.value_or(box.most.z());
  const double below = std::max(0.05 * std::max(size.x(), size.y()), 0.1);
  const stock::StockBox block{.x_min = box.least.x(),
                              .y_min = box.least.y(),
                              .x_max = box.most.x(),
                              .y_max = box.most.y(),
                              .top = top,
                              .bottom = std::min(lowest, top) - below};
  const double usual = std::clamp(
      std::sqrt(size.x() * size.y() / kBlockCells), kMinBlockCellMm, stock::kGreatestCellMm);
  const double cell = options.cell_mm.value_or(usual);
  std::string fault = fault_of(block, cell);
  if (fault.empty()) fault = fault_of_comparison(block, cell);
  if (!fault.empty()) throw std::invalid_argument{"the surface does not fit a stock: " + fault};
  return stock::Stock{block, cell};
}

void carve(stock::Stock& block, const SurfacePath& path, const stock::Cutter& cutter) {
  stock::Carver carver{block, cutter};
  const double chord_mm = 0.125 * std::min(block.cell_x_mm(), block.cell_y_mm());
  std::size_t begin = 0;
  for (const SurfaceRun& run : path.runs) {
    for (std::size_t i = begin; i < run.end; ++i) {
      const SpaceLine line = line_of(path.stretches[i], chord_mm);
      if (i == begin) {
        stock::Pose above = pose_of(line.front());
        above.z_mm = std::max(above.z_mm, block.box().top);
        carver.sweep({.from = above, .to = pose_of(line.front())});
      }
      for (std::size_t k = 0; k + 1 < line.size(); ++k) {
        carver.sweep({.from = pose_of(line[k]),
                      .to = pose_of(line[k + 1]),
                      .side_slack_mm = chord_mm,
                      .up_slack_mm = chord_mm});
      }
    }
    begin = run.end;
  }
}

}  // namespace sim::surface
