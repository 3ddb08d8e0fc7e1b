#include "host-sim/pocket/path_rows.hpp"

namespace sim::pocket {

void PathRows::end_row() {
  const auto end = static_cast<std::uint32_t>(points.size());
  const std::uint32_t begin = row_ends.empty() ? 0 : row_ends.back();
  if (end > begin) row_ends.push_back(end);
}

void PathRows::append(const PathRows& rows, double up_mm) {
  const auto before = static_cast<std::uint32_t>(points.size());
  for (cnc::pocket::PathPoint<double> point : rows.points) {
    point.z += up_mm;
    points.push_back(point);
  }
  for (const std::uint32_t end : rows.row_ends) row_ends.push_back(before + end);
}

}  // namespace sim::pocket
