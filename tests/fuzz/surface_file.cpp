/// libFuzzer: any bytes as a measured surface, with repair and without.

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <stdexcept>
#include <string_view>

#include "host-sim/surface/read_surface.hpp"

namespace {

void require_surface(bool holds, const char* rule) {
  if (holds) return;
  std::fprintf(stderr, "violated: %s\n", rule);
  std::abort();
}

void judge_surface(const sim::surface::SurfaceInput& surface) {
  const sim::surface::Mesh& mesh = surface.mesh;
  require_surface(!mesh.facets.empty(), "a surface has a facet");
  for (const Eigen::Vector3d& point : mesh.points) {
    require_surface(point.allFinite(), "coordinates are finite");
    require_surface(point.cwiseAbs().maxCoeff() <= sim::surface::kFarthestMm, "and near");
  }
  for (const auto& facet : mesh.facets) {
    for (const std::uint32_t corner : facet) {
      require_surface(corner < mesh.points.size(), "corners are points");
    }
    require_surface(facet[0] != facet[1] && facet[1] != facet[2] && facet[2] != facet[0],
                    "a facet has three corners");
  }
  if (!surface.grid) return;
  const sim::surface::PointGrid& grid = *surface.grid;
  require_surface(grid.rows >= 2 && grid.columns >= 2, "a grid has rows and columns");
  require_surface(grid.points.size() == grid.rows * grid.columns, "rows have equal lengths");
  require_surface(grid.points == mesh.points, "the mesh is that of the grid");
}

void read_and_judge(std::string_view bytes, const sim::surface::ReadOptions& options) {
  try {
    judge_surface(sim::surface::read_surface(bytes, "fuzz", options));
  } catch (const std::invalid_argument& error) {
    const std::string_view text{error.what()};
    require_surface(text.starts_with("fuzz:"), "a refusal names the file");
    require_surface(text.find("; ") != std::string_view::npos, "and a remedy");
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view bytes{reinterpret_cast<const char*>(data), size};
  read_and_judge(bytes, {});
  read_and_judge(bytes, {.unit_mm = 25.4, .pitch_mm = 0.5, .height_mm = 2.0, .repair = true});
  return 0;
}
