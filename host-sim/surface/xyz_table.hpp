#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace sim::surface {

/// Points of a text in the order of its lines.
struct XyzTable {
  std::vector<Eigen::Vector3d> points;  ///< In the file's unit.
  std::vector<std::uint32_t> lines;     ///< From 1.
  /// Index of the first point behind each blank line between points.
  std::vector<std::size_t> breaks;
  std::vector<std::string> notes;
};

/// Reads the lines of an XYZ text or CSV file: three numbers, or more of which a header names
/// three or the first counts the points. Throws std::invalid_argument for lines of another kind.
[[nodiscard]] XyzTable read_xyz_table(std::string_view text, const std::string& name);

}  // namespace sim::surface
