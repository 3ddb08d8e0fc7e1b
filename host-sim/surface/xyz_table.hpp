#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace sim::surface {

/// Points of a text, in the order of the lines.
struct XyzTable {
  std::vector<Eigen::Vector3d> points;  ///< Points in the file's unit.
  std::vector<std::uint32_t> lines;     ///< Line of each point, counted from 1.
  /// Index of the first point after each blank line between points.
  std::vector<std::size_t> breaks;
  std::vector<std::string> notes;
};

/// Reads the lines of an XYZ text or CSV file. A line has three numbers. It may have more numbers
/// if a header names X, Y and Z, or if the first number counts the points. Throws
/// std::invalid_argument for other lines.
[[nodiscard]] XyzTable read_xyz_table(std::string_view text, const std::string& name);

}  // namespace sim::surface
