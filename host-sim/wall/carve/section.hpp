#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

#include "host-sim/surface/mesh.hpp"
#include "host-sim/wall/carve/columns.hpp"

namespace sim::wall {

/// A vertical section plane between two points in plan, mm.
struct SectionLine {
  Eigen::Vector2d from = Eigen::Vector2d::Zero();
  Eigen::Vector2d until = Eigen::Vector2d::UnitX();

  [[nodiscard]] double length_mm() const { return (until - from).norm(); }
};

/// A range of heights with remaining material, between two distances along a section.
struct SectionBar {
  double from_mm = 0.0;
  double until_mm = 0.0;
  HeightRange range;
};

/// Returns the remaining material along a section, from the columns whose cells the section
/// crosses. The section may extend beyond the block.
/// @pre the section has a length
[[nodiscard]] std::vector<SectionBar> section_of(const Columns& columns, const SectionLine& line);

/// Returns the lines in which a section cuts a mesh. The coordinates of their ends are the distance
/// along the section and the height.
[[nodiscard]] std::vector<std::array<Eigen::Vector2d, 2>> section_of(const surface::Mesh& mesh,
                                                                     const SectionLine& line);

}  // namespace sim::wall
