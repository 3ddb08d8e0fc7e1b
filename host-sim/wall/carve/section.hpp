#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

#include "host-sim/surface/mesh.hpp"
#include "host-sim/wall/carve/columns.hpp"

namespace sim::wall {

/// An upright plane between two points of the plan, mm.
struct SectionLine {
  Eigen::Vector2d from = Eigen::Vector2d::Zero();
  Eigen::Vector2d until = Eigen::Vector2d::UnitX();

  [[nodiscard]] double length_mm() const { return (until - from).norm(); }
};

/// The part of the columns that is left between two distances along a section.
struct SectionBar {
  double from_mm = 0.0;
  double until_mm = 0.0;
  HeightRange range;
};

/// Returns the nearest columns along a section, each from half-way to the one before it to half-way
/// to the next. The section may leave the block. @pre it has a length
[[nodiscard]] std::vector<SectionBar> section_of(const Columns& columns, const SectionLine& line);

/// Returns the lines in which a section cuts a mesh: distances along the section, and heights.
[[nodiscard]] std::vector<std::array<Eigen::Vector2d, 2>> section_of(const surface::Mesh& mesh,
                                                                     const SectionLine& line);

}  // namespace sim::wall
