#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

#include "host-sim/surface/mesh.hpp"
#include "host-sim/wall/carve/columns.hpp"

namespace sim::wall {

/// A vertical plane between two points of the plan, mm.
struct SectionLine {
  Eigen::Vector2d from = Eigen::Vector2d::Zero();
  Eigen::Vector2d until = Eigen::Vector2d::UnitX();

  [[nodiscard]] double length_mm() const { return (until - from).norm(); }
};

/// A range of heights that is left of the columns between two distances along a section.
struct SectionBar {
  double from_mm = 0.0;
  double until_mm = 0.0;
  HeightRange range;
};

/// Returns the columns nearest to a section, each from half way to the previous column to half way
/// to the next. The section may leave the block.
/// @pre the section has a length
[[nodiscard]] std::vector<SectionBar> section_of(const Columns& columns, const SectionLine& line);

/// Returns the lines in which a section cuts a mesh. The coordinates are the distance along the
/// section and the height.
[[nodiscard]] std::vector<std::array<Eigen::Vector2d, 2>> section_of(const surface::Mesh& mesh,
                                                                     const SectionLine& line);

}  // namespace sim::wall
